#include "kernel.h"

const fusee::drawing::Kernel* fusee_pictures_kernel() {
    using namespace fusee;
    static constexpr drawing::Kernel kernel{drawing::png_of_svg, drawing::pdf};
    return &kernel;
}
