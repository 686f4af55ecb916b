#include "fusee/brep/brep.h"

#include "fusee/core/module.h"
#include "kernel/kernel.h"

namespace fusee::brep {

namespace {

/// OpenCASCADE takes 60 ms to start: it is loaded when a solid is built.
const Kernel& kernel() {
    static const Kernel& loaded =
        *reinterpret_cast<decltype(&fusee_brep_kernel)>(core::loaded_function("fusee_brep_kernel.so", "fusee_brep_kernel"))();
    return loaded;
}

}  // namespace

core::Outcome<Brep> build(const solid::Part& part) { return kernel().build(part); }

core::Outcome<Brep> extruded(std::span<const solid::Extrusion> shapes) { return kernel().extruded(shapes); }

core::Outcome<Brep> mirrored(const Brep& solid) { return kernel().mirrored(solid); }

std::vector<PlaneSpline> outline_splines(const solid::Part& part, double offset_mm) { return kernel().outline_splines(part, offset_mm); }

}  // namespace fusee::brep
