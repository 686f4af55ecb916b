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

#include "fusee/exchange/brep.h"
#include "fusee/solid/outline.h"

namespace fusee::exchange::brep {

namespace {

constexpr double kSlopeStep = 1e-4;     // of the one-sided differences at a rail's ends [rad]
constexpr double kSamePoint_mm = 1e-9;  // distance of points that count as one in a spline
constexpr int kFirstCount = 25;         // nodes; more where they are needed
constexpr double kLeastStep = 1e-6;     // [rad]: 0.04 um of a radius of 40 mm, limit of the refinement at a corner
constexpr double kByLength = 0.5;       // share of the parameter that grows with the rails' length; the rest grows with psi

double slope_step(const Nodes& nodes) { return std::min(kSlopeStep, 0.1 * (nodes.nodes.back().psi - nodes.nodes.front().psi)); }

/// d rail/dpsi at an end, from inside.
gp_Vec slope(const Rail& rail, double psi, double step) {
    const gp_Pnt a = point(rail(psi)), b = point(rail(psi + step)), c = point(rail(psi + 2.0 * step));
    return (gp_Vec(a, b) * 4.0 - gp_Vec(a, c)) / (2.0 * step);
}

/// Growth of the parameter of splines through these rails over psi [mm].
class Pace {
public:
    Pace(const std::vector<Rail>& rails, core::Range psi) : rails_(rails) {
        double length_mm = 0.0;
        for (const core::Range& part : equal_pieces(psi, kFirstCount - 1)) length_mm += length(part.low, part.high);
        even_ = length_mm / psi.width();
    }
    [[nodiscard]] double operator()(double from, double to) const {
        return kByLength * length(from, to) + (1.0 - kByLength) * even_ * (to - from);
    }
    /// d parameter/dpsi at an end, from inside.
    [[nodiscard]] double slope(double psi, double step) const {
        return std::abs(4.0 * (*this)(psi, psi + step) - (*this)(psi, psi + 2.0 * step)) / (2.0 * std::abs(step));
    }

private:
    /// Mean of the rails' lengths, with the sign of `to - from`: chords and half chords, extrapolated (Richardson).
    [[nodiscard]] double length(double from, double to) const {
        double sum = 0.0;
        for (const Rail& rail : rails_) {
            const gp_Pnt a = point(rail(from)), middle = point(rail(0.5 * (from + to))), b = point(rail(to));
            sum += (4.0 * (a.Distance(middle) + middle.Distance(b)) - a.Distance(b)) / 3.0;
        }
        return std::copysign(sum / static_cast<double>(rails_.size()), to - from);
    }
    const std::vector<Rail>& rails_;
    double even_ = 0.0;  ///< mean length over psi [mm/rad]
};

Nodes placed_nodes(const std::vector<double>& psi, const Pace& pace) {
    Nodes placed;
    placed.nodes.push_back({psi.front(), 0.0});
    for (std::size_t i = 1; i < psi.size(); ++i) {
        const double middle = 0.5 * (psi[i - 1] + psi[i]), at = placed.nodes.back().at + pace(psi[i - 1], middle);
        placed.middles.push_back({middle, at});
        placed.nodes.push_back({psi[i], at + pace(middle, psi[i])});
    }
    placed.begin_pace = pace.slope(psi.front(), slope_step(placed));
    placed.end_pace = pace.slope(psi.back(), -slope_step(placed));
    return placed;
}

PlaneSpline flattened(const Handle(Geom_BSplineCurve) & curve) {
    PlaneSpline plane;
    plane.degree = curve->Degree();
    for (int i = 1; i <= curve->NbKnots(); ++i)
        plane.knots.insert(plane.knots.end(), static_cast<std::size_t>(curve->Multiplicity(i)), curve->Knot(i));
    for (int i = 1; i <= curve->NbPoles(); ++i) plane.control_mm.push_back({curve->Pole(i).X(), curve->Pole(i).Y()});
    return plane;
}

}  // namespace

double allowed_mm(const cam::Cam& cam) { return cam.has_roller() ? 1e-5 : 2e-4; }

std::vector<core::Range> divided(core::Range psi, const std::vector<double>& places) {
    constexpr double kSame = 1e-6;  // [rad]
    std::vector<double> borders{psi.low, psi.high};
    for (const double place : places)
        if (place > psi.low + kSame && place < psi.high - kSame) borders.push_back(place);
    std::sort(borders.begin(), borders.end());
    std::vector<core::Range> parts;
    for (std::size_t i = 1; i < borders.size(); ++i) parts.push_back({borders[i - 1], borders[i]});
    return parts;
}

std::vector<core::Range> equal_pieces(core::Range psi, int count) {
    std::vector<core::Range> parts;
    double low = psi.low;
    for (int i = 1; i <= count; ++i) {
        const double high = i == count ? psi.high : psi.low + psi.width() * i / count;
        parts.push_back({low, high});
        low = high;
    }
    return parts;
}

std::vector<core::Range> smooth_pieces(const cam::Cam& cam, int idle_pieces) {
    const core::Range groove = cam.groove_psi, working = cam.working_psi;
    if (!cam.closed()) return divided(groove, {working.low, working.high});
    std::vector<double> borders{core::within_turn(working.low, groove.low)};
    for (const core::Range& idle : equal_pieces({working.high, working.low + core::kTurn}, idle_pieces))
        borders.push_back(core::within_turn(idle.low, groove.low));
    return divided({groove.low, groove.low + core::kTurn}, borders);
}

gp_Pnt point(const solid::Vec3& p) { return {p[0], p[1], p[2]}; }

Strip ruled(Rail low, Rail high) { return {{std::move(low), std::move(high)}, {1.0, 1.0}, 1}; }

Strip arcs(std::vector<Rail> rails, double half) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < rails.size(); ++i) weights.push_back(i % 2 == 0 ? 1.0 : std::cos(half));
    return {std::move(rails), std::move(weights), 2};
}

Handle(Geom_BSplineCurve) spline(const Rail& rail, const Nodes& nodes) {
    const int count = static_cast<int>(nodes.nodes.size());
    Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
    Handle(TColStd_HArray1OfReal) places = new TColStd_HArray1OfReal(1, count);
    for (int i = 0; i < count; ++i) {
        const Node& node = nodes.nodes[static_cast<std::size_t>(i)];
        points->SetValue(i + 1, point(rail(node.psi)));
        places->SetValue(i + 1, node.at);
    }
    GeomAPI_Interpolate through(points, places, false, kSamePoint_mm);
    const double step = slope_step(nodes), begin = nodes.nodes.front().psi, end = nodes.nodes.back().psi;
    through.Load(slope(rail, begin, step) / nodes.begin_pace, slope(rail, end, -step) / nodes.end_pace, false);
    through.Perform();
    return through.Curve();
}

std::vector<double> deviations_mm(const Rail& rail, const Nodes& nodes) {
    const Handle(Geom_BSplineCurve) curve = spline(rail, nodes);
    std::vector<double> deviations;
    for (const Node& middle : nodes.middles) deviations.push_back(curve->Value(middle.at).Distance(point(rail(middle.psi))));
    return deviations;
}

Nodes nodes_for(const std::vector<Rail>& rails, core::Range psi, double allowed_mm) {
    const Pace pace(rails, psi);
    std::vector<double> directions{psi.low};
    for (const core::Range& part : equal_pieces(psi, kFirstCount - 1)) directions.push_back(part.high);
    while (true) {
        Nodes nodes = placed_nodes(directions, pace);
        std::vector<double> worst(nodes.middles.size());
        for (const Rail& rail : rails) {
            const std::vector<double> own = deviations_mm(rail, nodes);
            for (std::size_t i = 0; i < worst.size(); ++i) worst[i] = std::max(worst[i], own[i]);
        }
        std::vector<double> finer{psi.low};
        for (std::size_t i = 0; i < worst.size(); ++i) {
            if (worst[i] > allowed_mm && directions[i + 1] - directions[i] > kLeastStep) finer.push_back(nodes.middles[i].psi);
            finer.push_back(directions[i + 1]);
        }
        if (finer.size() == directions.size()) return nodes;
        directions = std::move(finer);
    }
}

TopoDS_Face face_of(const Strip& strip, const Nodes& nodes) {
    std::vector<Handle(Geom_BSplineCurve)> curves;
    for (const Rail& rail : strip.rails) curves.push_back(spline(rail, nodes));
    const int along = curves.front()->NbPoles(), across = static_cast<int>(curves.size()), knots = curves.front()->NbKnots();
    TColgp_Array2OfPnt poles(1, across, 1, along);
    TColStd_Array2OfReal weights(1, across, 1, along);
    for (int j = 1; j <= across; ++j)
        for (int i = 1; i <= along; ++i) {
            poles(j, i) = curves[static_cast<std::size_t>(j - 1)]->Pole(i);
            weights(j, i) = strip.weights[static_cast<std::size_t>(j - 1)];
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
        new Geom_BSplineSurface(poles, weights, across_knots, along_knots, across_times, along_times, strip.degree, 3);
    return BRepBuilderAPI_MakeFace(surface, kSamePoint_mm).Face();
}

std::vector<PlaneSpline> outline_splines(const solid::Part& part, double offset_mm) {
    const Rail rail = [&](double psi) {
        const solid::Point2 p = solid::flange_point(part.cam.path(psi), offset_mm, 0.0).point;
        return solid::Vec3{p[0], p[1], 0.0};
    };
    std::vector<PlaneSpline> splines;
    for (const core::Range& psi : smooth_pieces(part.cam))
        splines.push_back(flattened(spline(rail, nodes_for({rail}, psi, allowed_mm(part.cam)))));
    return splines;
}

}  // namespace fusee::exchange::brep
