#include "contour.h"

#include <algorithm>
#include <memory>

#include "enclosure.h"

namespace fusee::cam {

namespace {

using math::Interval;
using math::Jet;

/// rho between two knots of an arc that starts at `begin_psi` in `direction`, as a function of psi.
Jet rho_between(const IdleArc::Knot& from, const IdleArc::Knot& to, const Jet& psi, double begin_psi, int direction) {
    const Jet gone = static_cast<double>(direction) * (psi - begin_psi) - from.x;
    const Interval rate = (Interval(to.state.rho) - from.state.rho) / (Interval(to.x) - from.x);
    return from.state.rho + Jet(rate, Interval(0.0)) * gone;
}

/// One piece for each pair of knots, by psi. @param finish adds the arc's height
template <class Finish>
std::vector<ContourPiece> by_psi(const IdleArc& arc, double begin_psi, int direction, const Finish& finish) {
    std::vector<ContourPiece> result;
    const auto& knots = arc.knots();
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const IdleArc::Knot from = knots[i - 1], to = knots[i];
        const double a = begin_psi + direction * from.x, b = begin_psi + direction * to.x;
        result.push_back({{std::min(a, b), std::max(a, b)}, false, [=](const Interval& box) {
                              ContourJet at;
                              at.psi = Jet::parameter(box);
                              at.rho = rho_between(from, to, at.psi, begin_psi, direction);
                              finish(at);
                              return at;
                          }});
    }
    return result;
}

}  // namespace

std::vector<ContourPiece> working_pieces(const ArmFunction& arm, const CamOptions& options, const Height& height) {
    std::vector<ContourPiece> result;
    const auto heights = std::make_shared<const Height>(height);
    for (const spring::LawSegment& law : spring::segments(arm.law()))
        result.push_back(
            {law.parameter, true, [arm, options, heights, law](const Interval& box) {
                 const ContactJet contact = touch(arm.kind(), arm.over(law.over(box)), options);
                 const Height::AxialSlope axial_slope = heights->over(contact.path.psi.value);
                 return ContourJet{contact.path.psi, contact.path.rho, contact.arm.angle, axial_slope.first, axial_slope.second};
             }});
    return result;
}

std::vector<ContourPiece> idle_pieces(const IdleArc& arc, double begin_psi) {
    return by_psi(arc, begin_psi, +1, [](ContourJet&) {});
}

std::vector<ContourPiece> run_out_pieces(const RunOut& run_out) {
    return by_psi(run_out.arc(), run_out.end().psi, run_out.direction(), [run_out](ContourJet& at) {
        const Height::AxialSlope axial_slope = run_out.over(at.rho);
        at.axial_slope = axial_slope.first;
        at.axial_slope_rate = axial_slope.second;
    });
}

}  // namespace fusee::cam
