#include <fmt/format.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <Precision.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "failure.h"
#include "fusee/exchange/brep.h"
#include "measure.h"

namespace fusee::exchange::brep {

namespace {

/// Does the solid enclose its inside, not everything else?
bool is_finite(const TopoDS_Shape& solid) {
    BRepClass3d_SolidClassifier place(solid);
    place.PerformInfinitePoint(Precision::Confusion());
    return place.State() == TopAbs_OUT;
}

/// A reflection keeps the size of a volume: integrating it again would take longer than everything else here.
Brep reflected_solid(const Brep& solid) {
    gp_Trsf reflection;
    reflection.SetMirror(gp_Ax2(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 1.0, 0.0)));
    const TopoDS_Shape shape = BRepBuilderAPI_Transform(*solid.shape, reflection, true).Shape();
    const std::size_t faces = count_faces(shape);
    if (faces != solid.faces || !is_one_solid(shape) || !is_finite(shape)) return {};
    return {std::make_shared<TopoDS_Shape>(shape), faces, solid.volume_mm3, solid.deviation_mm};
}

}  // namespace

core::Outcome<Brep> mirrored(const Brep& solid) {
    Brep other;
    std::string what = "OpenCASCADE builds no valid solid for the mirror image";
    try {
        guard([&] { other = reflected_solid(solid); });
    } catch (const Failure& failure) {
        what += fmt::format(" ({})", failure.what());
    }
    if (other.shape) return other;
    core::Finding f = core::error_finding("brep.validity", what, 0.0, core::Bound::kAtLeast, 1.0, "solids");
    f.suggestion = core::change("outputs.pair", "false").or_else("outputs.formats without \"step\"");
    f.source = "OpenCASCADE: one valid solid; docs/theory/cams.md";
    return f;
}

}  // namespace fusee::exchange::brep
