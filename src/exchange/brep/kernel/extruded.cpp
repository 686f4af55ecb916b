#include <fmt/format.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <gp_Trsf.hxx>

#include "failure.h"
#include "fusee/core/units.h"
#include "fusee/exchange/brep.h"
#include "measure.h"
#include "strip.h"

namespace fusee::exchange::brep {

namespace {

constexpr double kSameVolume = 1e-6;  // relative: integrals over planes and cylinders are exact but for rounding

TopoDS_Shape solid_of(const solid::Extrusion& shape) {
    solid::Outline outer = shape.outline;
    if (outer.empty() && shape.radius_mm > 0.0) outer = solid::circle(shape.radius_mm);
    if (outer.empty())
        for (const solid::Point2& corner : solid::ring_of(shape, 0.0)) outer.push_back({corner});
    std::vector<solid::Outline> holes;
    for (const solid::RoundHole& hole : shape.holes) holes.push_back(solid::circle(hole.radius_mm, {hole.x_mm, hole.y_mm}));
    holes.insert(holes.end(), shape.bores.begin(), shape.bores.end());
    return BRepBuilderAPI_Transform(prism(outer, holes, 0.0, shape.length_mm), transform_of(shape.frame), true).Shape();
}

TopoDS_Shape united(std::span<const solid::Extrusion> shapes) {
    const TopoDS_Shape first = solid_of(shapes.front());
    if (shapes.size() == 1) return solids_of(first);
    TopTools_ListOfShape others;
    for (const solid::Extrusion& shape : shapes.subspan(1)) others.Append(solid_of(shape));
    TopTools_ListOfShape firsts;
    firsts.Append(first);
    BRepAlgoAPI_Fuse fuse;
    fuse.SetArguments(firsts);
    fuse.SetTools(others);
    fuse.SetRunParallel(false);
    fuse.SetCheckInverted(false);  // prisms are not
    fuse.Build();
    ShapeUpgrade_UnifySameDomain unify(fuse.IsDone() ? fuse.Shape() : TopoDS_Shape());
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
