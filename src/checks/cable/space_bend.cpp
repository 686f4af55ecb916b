#include <vector>

#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kStep = core::kPi / 900.0;  // [rad] between points of the run-out: rho and pitch change within 0.05 rad there

/// The groove where a cable lies in it: from the anchor to the working arc's other end, by rising psi.
std::vector<cam::PathPoint> under_cable(const cam::Cam& cam) {
    std::vector<cam::PathPoint> path;
    for (const cam::Contact& c : cam.working) path.push_back(c.path);
    if (path.front().psi > path.back().psi) std::reverse(path.begin(), path.end());
    if (!cam.path) return path;
    const double low = std::min(cam.anchor_psi, path.front().psi), high = std::max(cam.anchor_psi, path.back().psi);
    std::vector<cam::PathPoint> before, after;
    for (double psi = low; psi < path.front().psi - 0.5 * kStep; psi += kStep) before.push_back(cam.path(psi));
    for (double psi = path.back().psi + kStep; psi < high + 0.5 * kStep; psi += kStep) after.push_back(cam.path(psi));
    path.insert(path.begin(), before.begin(), before.end());
    path.insert(path.end(), after.begin(), after.end());
    return path;
}

/// Curvature of a curve in space (docs/theory/cams.md, eq. 15).
struct Bend {
    double radius = 0.0;  ///< [m]
    double twist = 0.0;   ///< (z'' - m rho')/rho: rate at which its slope changes
};

/// The bend by differences with both neighbours, which need not be evenly spaced.
Bend bend_at(const cam::PathPoint& a, const cam::PathPoint& b, const cam::PathPoint& c) {
    const double before = b.psi - a.psi, after = c.psi - b.psi, both = before + after;
    const double rise = (b.z - a.z) / before, next_rise = (c.z - b.z) / after;
    const double slope = (rise * after + next_rise * before) / (both * b.rho);  // m = z'/rho
    const double twist = (2.0 * (next_rise - rise) / both - slope * (c.rho - a.rho) / both) / b.rho, turn = 1.0 + slope * slope;
    return {b.rho * turn * std::sqrt(turn / (turn + twist * twist)), std::abs(twist)};
}

/// The pitch at which the groove's slope changes slowly enough, or the cable that allows this bend.
core::Suggestion nearest_change(const Design& design, const Bend& bend, double rho, double allowed) {
    const double needed = 0.5 * design.cable.diameter * (1.0 + allowed), ratio = rho / needed;
    const core::Suggestion thinner = change("cable.diameter_mm", down(mm_from_m(2.0 * bend.radius / (1.0 + allowed))));
    const cam::PathOptions& path = design.part.cam.options.path;
    if (path.lead != cam::Lead::kConstantPitch || ratio <= 1.0 || bend.twist <= 0.0) return thinner;
    const double slower = std::min(1.0, std::sqrt(ratio * ratio - 1.0) / bend.twist);
    return change(design, "path.pitch_mm", down(mm_from_m(path.pitch) * slower)).or_else(thinner);
}

core::Findings measure_cable_space_bend(const Design& design, const Allowed& allowed) {
    const cam::Cam& cam = design.part.cam;
    if (cam.closed() || cam.working.size() < 3) return {};
    const std::vector<cam::PathPoint> path = under_cable(cam);
    Bend sharpest{path.front().rho, 0.0};
    const cam::PathPoint* worst = &path.front();
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
        if (const Bend bend = bend_at(path[i - 1], path[i], path[i + 1]); !(bend.radius >= sharpest.radius))
            sharpest = bend, worst = &path[i];
    const double d = design.cable.diameter, ratio = (2.0 * sharpest.radius - d) / d;
    core::Finding f = judge_bend(ratio, design, allowed);
    f.what = fmt::format("D/d at the groove's sharpest bend in space between anchor and guide, radius {:.3f} mm, {:.3f} mm in the plane",
                         mm_from_m(sharpest.radius), mm_from_m(worst->rho));
    locate(f, design, *worst);
    f.suggestion = nearest_change(design, sharpest, worst->rho, f.allowed);
    return {f};
}

}  // namespace

Rule cable_space_bend() {
    return {"cable.space_bend",
            "a helical groove whose slope changes so fast that it bends the cable too sharply",
            "helix: D/d = (2 R - d)/d with R the least radius of curvature in space, from the anchor to the working arc's end",
            "by construction, as cable.bend_ratio; docs/theory/cams.md, eq. 15",
            {required(kAtLeast, "", "the construction's critical D/d, or cable.min_bend_ratio"),
             review(kAtLeast, "", "the construction's recommended D/d")},
            measure_cable_space_bend};
}

}  // namespace fusee::checks
