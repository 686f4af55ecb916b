#include "fusee/exchange/brep.h"

#include "fusee/core/module.h"
#include "kernel/kernel.h"

namespace fusee::exchange::brep {

namespace {

/// OpenCASCADE takes 60 ms to start: it is loaded when a solid is built.
const Kernel& brep_kernel() {
    static const Kernel& loaded =
        *reinterpret_cast<decltype(&fusee_brep_kernel)>(core::loaded_function("fusee_brep_kernel.so", "fusee_brep_kernel"))();
    return loaded;
}

}  // namespace

core::Outcome<Brep> build(const solid::Part& part) { return brep_kernel().build(part); }

core::Outcome<Brep> extruded(std::span<const solid::Extrusion> shapes) { return brep_kernel().extruded(shapes); }

core::Outcome<Brep> mirrored(const Brep& solid) { return brep_kernel().mirrored(solid); }

std::vector<PlaneSpline> outline_splines(const solid::Part& part, double offset_mm) {
    return brep_kernel().outline_splines(part, offset_mm);
}

}  // namespace fusee::exchange::brep
