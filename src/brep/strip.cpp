#include "strip.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <algorithm>
#include <cmath>

#include "fusee/core/turn.h"

namespace fusee::brep {

namespace {

constexpr double kSlopeStep = 1e-4;  // of the one-sided differences at a rail's ends [rad]
constexpr double kSame_mm = 1e-9;    // points that count as one when a spline is laid through them
constexpr int kFirstCount = 25;      // nodes; more where they are needed
constexpr double kLeastStep = 1e-6;  // [rad]: 0.04 um of a radius of 40 mm, where a corner would be refined for ever

/// d rail/dpsi at an end, from inside.
gp_Vec slope(const Rail& rail, double psi, double step) {
    const gp_Pnt a = point(rail(psi)), b = point(rail(psi + step)), c = point(rail(psi + 2.0 * step));
    return (gp_Vec(a, b) * 4.0 - gp_Vec(a, c)) / (2.0 * step);
}

}  // namespace

std::vector<core::Range> parted(core::Range psi, const std::vector<double>& places) {
    constexpr double kSame = 1e-6;  // [rad]
    std::vector<double> borders{psi.low, psi.high};
    for (const double place : places)
        if (place > psi.low + kSame && place < psi.high - kSame) borders.push_back(place);
    std::sort(borders.begin(), borders.end());
    std::vector<core::Range> parts;
    for (std::size_t i = 1; i < borders.size(); ++i) parts.push_back({borders[i - 1], borders[i]});
    return parts;
}

std::vector<core::Range> smooth_parts(const cam::Cam& cam) {
    const core::Range groove = cam.groove_psi, working = cam.working_psi;
    if (!cam.closed()) return parted(groove, {working.low, working.high});
    return parted({groove.low, groove.low + core::kTurn},
                  {core::within_turn(working.low, groove.low), core::within_turn(working.high, groove.low)});
}

gp_Pnt point(const solid::Vec3& p) { return {p[0], p[1], p[2]}; }

Strip ruled(Rail low, Rail high) { return {{std::move(low), std::move(high)}, {1.0, 1.0}, 1}; }

Strip arcs(std::vector<Rail> rails, double half) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < rails.size(); ++i) weights.push_back(i % 2 == 0 ? 1.0 : std::cos(half));
    return {std::move(rails), std::move(weights), 2};
}

Handle(Geom_BSplineCurve) spline(const Rail& rail, const Nodes& nodes) {
    const int count = static_cast<int>(nodes.size());
    Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
    Handle(TColStd_HArray1OfReal) places = new TColStd_HArray1OfReal(1, count);
    for (int i = 0; i < count; ++i) {
        const double psi = nodes[static_cast<std::size_t>(i)];
        points->SetValue(i + 1, point(rail(psi)));
        places->SetValue(i + 1, psi);
    }
    GeomAPI_Interpolate through(points, places, false, kSame_mm);
    const double step = std::min(kSlopeStep, 0.1 * (nodes.back() - nodes.front()));
    through.Load(slope(rail, nodes.front(), step), slope(rail, nodes.back(), -step), false);
    through.Perform();
    return through.Curve();
}

std::vector<double> deviations_mm(const Rail& rail, const Nodes& nodes) {
    const Handle(Geom_BSplineCurve) curve = spline(rail, nodes);
    std::vector<double> deviations;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const double middle = 0.5 * (nodes[i] + nodes[i + 1]);
        deviations.push_back(curve->Value(middle).Distance(point(rail(middle))));
    }
    return deviations;
}

Nodes nodes_for(const std::vector<Rail>& rails, core::Range psi, double allowed_mm) {
    Nodes nodes;
    for (int i = 0; i < kFirstCount; ++i) nodes.push_back(i + 1 == kFirstCount ? psi.high : psi.low + psi.width() * i / (kFirstCount - 1));
    while (true) {
        std::vector<double> worst(nodes.size() - 1);
        for (const Rail& rail : rails) {
            const std::vector<double> own = deviations_mm(rail, nodes);
            for (std::size_t i = 0; i < worst.size(); ++i) worst[i] = std::max(worst[i], own[i]);
        }
        Nodes finer{nodes.front()};
        for (std::size_t i = 0; i < worst.size(); ++i) {
            if (worst[i] > allowed_mm && nodes[i + 1] - nodes[i] > kLeastStep) finer.push_back(0.5 * (nodes[i] + nodes[i + 1]));
            finer.push_back(nodes[i + 1]);
        }
        if (finer.size() == nodes.size()) return nodes;
        nodes = std::move(finer);
    }
}

TopoDS_Face face_of(const Strip& strip, const Nodes& nodes) {
    std::vector<Handle(Geom_BSplineCurve)> curves;
    for (const Rail& rail : strip.rails) curves.push_back(spline(rail, nodes));
    const int along = curves.front()->NbPoles(), across = static_cast<int>(curves.size()), knots = curves.front()->NbKnots();
    TColgp_Array2OfPnt poles(1, along, 1, across);
    TColStd_Array2OfReal weights(1, along, 1, across);
    for (int j = 1; j <= across; ++j)
        for (int i = 1; i <= along; ++i) {
            poles(i, j) = curves[static_cast<std::size_t>(j - 1)]->Pole(i);
            weights(i, j) = strip.weights[static_cast<std::size_t>(j - 1)];
        }
    TColStd_Array1OfReal along_knots(1, knots);
    TColStd_Array1OfInteger along_times(1, knots);
    for (int i = 1; i <= knots; ++i) {
        along_knots(i) = curves.front()->Knot(i);
        along_times(i) = curves.front()->Multiplicity(i);
    }
    const int pieces = (across - 1) / strip.degree;
    TColStd_Array1OfReal across_knots(1, pieces + 1);
    TColStd_Array1OfInteger across_times(1, pieces + 1);
    for (int i = 0; i <= pieces; ++i) {
        across_knots(i + 1) = i;
        across_times(i + 1) = i == 0 || i == pieces ? strip.degree + 1 : strip.degree;
    }
    const Handle(Geom_BSplineSurface) surface =
        new Geom_BSplineSurface(poles, weights, along_knots, across_knots, along_times, across_times, 3, strip.degree);
    return BRepBuilderAPI_MakeFace(surface, kSame_mm).Face();
}

}  // namespace fusee::brep
