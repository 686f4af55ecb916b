#include "fusee/brep/mirror.h"

#include <fmt/format.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "fusee/brep/failure.h"
#include "fusee/brep/measure.h"

namespace fusee::brep {

namespace {

Brep reflected(const Brep& solid) {
    gp_Trsf reflection;
    reflection.SetMirror(gp_Ax2(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 1.0, 0.0)));
    const TopoDS_Shape shape = BRepBuilderAPI_Transform(*solid.shape, reflection, true).Shape();
    if (!is_one_solid(shape)) return {};
    return {std::make_shared<TopoDS_Shape>(shape), count_faces(shape), volume_mm3(shape), solid.deviation_mm};
}

}  // namespace

core::Outcome<Brep> mirrored(const Brep& solid) {
    constexpr double kSameVolume = 1e-5;  // relative: each volume is integrated to 1e-6
    Brep other;
    std::string what = "OpenCASCADE builds no valid solid with the same volume for the mirror image";
    try {
        guard([&] { other = reflected(solid); });
    } catch (const Failure& failure) {
        what += fmt::format(" ({})", failure.what());
    }
    if (other.shape && std::abs(other.volume_mm3 / solid.volume_mm3 - 1.0) <= kSameVolume) return other;
    core::Finding f =
        core::error_finding("brep.validity", what, other.volume_mm3, core::Bound::kAtLeast, solid.volume_mm3 * (1.0 - kSameVolume), "mm^3");
    f.suggestion = "outputs.pair = false, or outputs.formats without \"step\"";
    f.source = "OpenCASCADE: one valid solid; docs/theory/cams.md";
    return f;
}

}  // namespace fusee::brep
