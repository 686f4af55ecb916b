#pragma once
#include "fusee/render/picture.h"
#include "fusee/render/svg.h"

namespace fusee::render {

/// The functions of this module that call cairo and librsvg, as the library fusee_pictures.so has them. The module itself has functions of
/// the same names, which load the library and call these.
struct Kernel {
    decltype(&render::png) png;
    decltype(&render::png_of_svg) png_of_svg;
    decltype(&render::pdf_of_svgs) pdf_of_svgs;
};

}  // namespace fusee::render

extern "C" [[gnu::visibility("default")]] const fusee::render::Kernel* fusee_pictures_kernel();
