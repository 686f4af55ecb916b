#include <fmt/format.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <cmath>
#include <gp_Trsf.hxx>
#include <string>

#include "failure.h"
#include "fusee/core/kept.h"
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
    fuse.SetCheckInverted(false);     // prisms are not
    fuse.SetGlue(BOPAlgo_GlueShift);  // they touch, without faces that cross each other
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

template <class Visit>
void each_number(solid::Outline& outline, const Visit& visit) {
    for (solid::Arc& arc : outline)
        for (double* number : {&arc.centre_mm[0], &arc.centre_mm[1], &arc.radius_mm, &arc.begin, &arc.end}) visit(*number);
}

template <class Visit>
void each_number(solid::Extrusion& shape, const Visit& visit) {
    for (double& entry : shape.frame.matrix().reshaped()) visit(entry);
    for (double* number : {&shape.radius_mm, &shape.half_x_mm, &shape.half_y_mm, &shape.length_mm}) visit(*number);
    each_number(shape.outline, visit);
    for (solid::RoundHole& hole : shape.holes)
        for (double* number : {&hole.x_mm, &hole.y_mm, &hole.radius_mm}) visit(*number);
    for (solid::Outline& bore : shape.bores) each_number(bore, visit);
}

/// The same for equal shapes alone.
std::string key_of(std::vector<solid::Extrusion>& shapes) {
    std::string key;
    const auto add = [&key](const auto& number) { key.append(reinterpret_cast<const char*>(&number), sizeof number); };
    for (solid::Extrusion& shape : shapes) {
        for (const std::size_t count : {shape.outline.size(), shape.holes.size(), shape.bores.size()}) add(count);
        for (const solid::Outline& bore : shape.bores) add(bore.size());
        each_number(shape, add);
    }
    return key;
}

core::Outcome<Brep> made(std::span<const solid::Extrusion> shapes) {
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

}  // namespace

core::Outcome<Brep> extruded(std::span<const solid::Extrusion> shapes) {
    constexpr std::size_t kBodies = 64;  // a joint has 50, most of them twice, and the designs of a study share them
    static core::Kept<std::string, Brep> bodies(kBodies);
    std::vector<solid::Extrusion> body(shapes.begin(), shapes.end());
    for (solid::Extrusion& shape : body) each_number(shape, [](double& number) { number += 0.0; });  // no -0: the other side has some
    std::string key = key_of(body);
    std::optional<Brep> known = bodies.find(key);
    if (!known) {
        const auto fresh = made(body);
        if (!fresh) return fresh;
        known = *fresh;
        bodies.keep(std::move(key), *known);
    }
    known->shape = std::make_shared<TopoDS_Shape>(BRepBuilderAPI_Copy(*known->shape).Shape());  // a shape twice would be one product
    return *std::move(known);
}

}  // namespace fusee::exchange::brep
