#pragma once
#include "fusee/exchange/brep.h"

namespace fusee::exchange::brep {

/// The functions of this module that call OpenCASCADE, as the library fusee_brep_kernel.so has them. The module itself has functions of the
/// same names, which load the library and call these.
struct Kernel {
    decltype(&brep::build) build;
    decltype(&brep::extruded) extruded;
    decltype(&brep::mirrored) mirrored;
    decltype(&brep::outline_splines) outline_splines;
};

}  // namespace fusee::exchange::brep

extern "C" [[gnu::visibility("default")]] const fusee::exchange::brep::Kernel* fusee_brep_kernel();
