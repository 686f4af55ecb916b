#pragma once
#include "fusee/drawing/sheet.h"

namespace fusee::drawing {

/// The functions of this module that call cairo, Pango and librsvg, as the library fusee_pictures.so has them. The module itself has
/// functions of the same names, which load the library and call these.
struct Kernel {
    decltype(&drawing::png_of_svg) png_of_svg;
    decltype(&drawing::pdf) pdf;
};

}  // namespace fusee::drawing

extern "C" [[gnu::visibility("default")]] const fusee::drawing::Kernel* fusee_pictures_kernel();
