#include <fmt/format.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <gp_Trsf.hxx>

#include "failure.h"
#include "fusee/core/units.h"
#include "fusee/exchange/brep.h"
#include "hub.h"
#include "measure.h"
#include "transform.h"

namespace fusee::exchange::brep {

namespace {

constexpr double kSameVolume = 1e-6;  // relative: integrals over planes and cylinders are exact but for rounding

TopoDS_Shape outer(const solid::Extrusion& shape) {
    if (!shape.outline.empty()) return prism({"", shape.outline, 0.0, shape.length_mm, false});
    if (shape.radius_mm > 0.0) return BRepPrimAPI_MakeCylinder(shape.radius_mm, shape.length_mm).Shape();
    const gp_Pnt low(-shape.half_x_mm, -shape.half_y_mm, 0.0);
    return BRepPrimAPI_MakeBox(low, 2.0 * shape.half_x_mm, 2.0 * shape.half_y_mm, shape.length_mm).Shape();
}

/// @pre at least one tool
TopoDS_Shape boolean(BRepAlgoAPI_BooleanOperation& operation, const TopoDS_Shape& body, const TopTools_ListOfShape& tools) {
    TopTools_ListOfShape bodies;
    bodies.Append(body);
    operation.SetArguments(bodies);
    operation.SetTools(tools);
    operation.SetRunParallel(false);
    operation.Build();
    return operation.IsDone() ? operation.Shape() : TopoDS_Shape();
}

TopoDS_Shape solid_of(const solid::Extrusion& shape) {
    TopoDS_Shape body = outer(shape);
    TopTools_ListOfShape holes;
    for (const solid::RoundHole& hole : shape.holes) {
        const gp_Ax2 axis(gp_Pnt(hole.x_mm, hole.y_mm, -1.0), gp_Dir(0.0, 0.0, 1.0));
        holes.Append(BRepPrimAPI_MakeCylinder(axis, hole.radius_mm, shape.length_mm + 2.0).Shape());
    }
    for (const solid::Outline& bore : shape.bores) holes.Append(prism({"", bore, -1.0, shape.length_mm + 1.0, false}));
    if (!holes.IsEmpty()) {
        BRepAlgoAPI_Cut cut;
        body = boolean(cut, body, holes);
    }
    return BRepBuilderAPI_Transform(body, transform_of(shape.frame), true).Shape();
}

TopoDS_Shape united(std::span<const solid::Extrusion> shapes) {
    const TopoDS_Shape first = solid_of(shapes.front());
    if (shapes.size() == 1) return solids_of(first);
    TopTools_ListOfShape others;
    for (const solid::Extrusion& shape : shapes.subspan(1)) others.Append(solid_of(shape));
    BRepAlgoAPI_Fuse fuse;
    ShapeUpgrade_UnifySameDomain unify(boolean(fuse, first, others));
    unify.Build();
    return solids_of(unify.Shape());
}

core::Finding not_the_sum(std::string what, double measured, double expected) {
    core::Finding f = core::error_finding("brep.validity", std::move(what), measured, core::Bound::kAtLeast, expected, "mm^3");
    f.suggestion = "shapes that touch and do not overlap";
    f.source = "OpenCASCADE: valid solids";
    return f;
}

double designed_mm3(const solid::Extrusion& shape) {
    double area = !shape.outline.empty()  ? solid::area_mm2(shape.outline)
                  : shape.radius_mm > 0.0 ? core::kPi * shape.radius_mm * shape.radius_mm
                                          : 4.0 * shape.half_x_mm * shape.half_y_mm;
    for (const solid::RoundHole& hole : shape.holes) area -= core::kPi * hole.radius_mm * hole.radius_mm;
    for (const solid::Outline& bore : shape.bores) area -= solid::area_mm2(bore);
    return area * shape.length_mm;
}

}  // namespace

core::Outcome<Brep> extruded(std::span<const solid::Extrusion> shapes) {
    double expected = 0.0;
    for (const solid::Extrusion& shape : shapes) expected += designed_mm3(shape);
    Brep body;
    std::string what = "OpenCASCADE builds no valid solids of these shapes";
    try {
        guard([&] {
            const TopoDS_Shape shape = united(shapes);
            if (BRepCheck_Analyzer(shape).IsValid())
                body = {std::make_shared<TopoDS_Shape>(shape), count_faces(shape), volume_mm3(shape), 0.0};
        });
    } catch (const Failure& failure) {
        what += fmt::format(" ({})", failure.what());
    }
    if (!body.shape) return not_the_sum(what, 0.0, expected);
    if (std::abs(body.volume_mm3 / expected - 1.0) > kSameVolume)
        return not_the_sum("the volume of the solids is not the sum of the shapes' volumes", body.volume_mm3, expected);
    return body;
}

}  // namespace fusee::exchange::brep
