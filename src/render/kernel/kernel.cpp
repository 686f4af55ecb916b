#include "kernel.h"

const fusee::render::Kernel* fusee_pictures_kernel() {
    using namespace fusee;
    static constexpr render::Kernel kernel{render::png, render::png_of_svg, render::pdf_of_svgs};
    return &kernel;
}
