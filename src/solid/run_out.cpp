#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "fusee/core/units.h"
#include "fusee/solid/sweep.h"
#include "refusals.h"

namespace fusee::solid {

namespace {

constexpr double kInside = 0.95;                                                     // share by which a suggestion stays inside the limit
constexpr core::Range kMargins{core::rad_from_deg(2.8), core::rad_from_deg(172.0)};  // of a profile

/// The end that needs the longer run-out.
bool worse_end(const ColumnMaker& maker) { return maker.run_out_needed(true).width > maker.run_out_needed(false).width; }
double needed(const ColumnMaker& maker) { return maker.run_out_needed(worse_end(maker)).width; }

/// The margin nearest to the given one, as a ratio, with which the run-out is short enough; empty if there is none.
core::Suggestion other_margin(const Part& part) {
    constexpr double kStep = 1.1, kGrooveOfMargin = 1.6;  // the groove extends this far beyond the working arc
    constexpr int kSteps = 45;                            // a factor of 70: the whole range
    cam::Cam other = part.cam;
    for (int i = 1; i <= kSteps; ++i)
        for (const int direction : {-1, 1}) {
            const double margin = part.cam.options.path.margin * std::pow(kStep, direction * i), beyond = kGrooveOfMargin * margin;
            if (!kMargins.holds(margin)) continue;
            other.groove_psi = {part.cam.working_psi.low - beyond, part.cam.working_psi.high + beyond};
            if (needed(ColumnMaker(other, part.section, flanges_of(part.options))) < kInside * kLongestRunOut)
                return core::change(std::string(to_string(part.cam.kind)) + ".path.margin_deg",
                                    fmt::format("{:.1f}", core::deg_from_rad(margin)));
        }
    return {};
}

/// The least run-out of a groove that ends at this contact. The contour is approximated by its circle of curvature there.
double needed_at(const cam::PathPoint& p, bool high) {
    const double farthest = p.rho + std::hypot(p.h - p.rho, p.slope);
    return (high ? p.slope : -p.slope) * farthest / (p.h * p.rho);
}

/// The load, nearest to this end of the law, at which the working arc could end; empty if the arc grows too fast everywhere.
core::Suggestion shorter_law(const cam::Cam& cam, bool high) {
    const std::vector<cam::Contact>& rows = cam.working;
    if (rows.empty()) return {};
    const bool loaded = (rows.back().path.psi > rows.front().path.psi) == high;  // the law's highest load lies at this end
    const auto fits = [&](const cam::Contact& c) { return needed_at(c.path, high) < kInside * kLongestRunOut; };
    if (loaded) {
        const auto last = std::find_if(rows.rbegin(), rows.rend(), fits);
        return last == rows.rend() ? core::Suggestion() : core::change("law.end_torque_Nm", core::number(last->arm.tau, 4));
    }
    const auto first = std::find_if(rows.begin(), rows.end(), fits);
    if (first == rows.end()) return {};
    const bool torsion = cam.kind == cam::PartKind::kSeries;
    return core::change("law.start_torque_Nm", core::number(first->arm.tau, 4))
        .with(fmt::format("{}.spring.{}", to_string(cam.kind), torsion ? "preload_rad" : "preload_mm"),
              core::number(torsion ? first->arm.state : core::mm_from_m(first->arm.state), 4));
}

}  // namespace

core::Findings check_run_outs(const Part& part, const ColumnMaker& maker) {
    if (part.cam.closed()) return {};
    const bool high = worse_end(maker);
    const ColumnMaker::RunOut need = maker.run_out_needed(high);
    if (need.width <= kLongestRunOut) return {};
    const cam::PathPoint at = part.cam.path(need.psi);
    core::Finding f = refusal(
        "solid.run_out",
        fmt::format("the contour grows too fast at the end of its groove (h' {:.3g} mm/rad at h {:.3g} mm): the lips turn back about "
                    "the axis before they reach the flange's radius of {:.3g} mm, and the land folds; needed run-out",
                    core::mm_from_m(at.slope), core::mm_from_m(at.h), maker.helix_radius_mm()),
        core::deg_from_rad(need.width), core::deg_from_rad(kLongestRunOut),
        fmt::format("{} at psi {:.1f} deg, z {:.2f} mm", to_string(part.cam.kind), core::deg_from_rad(need.psi), core::mm_from_m(at.z)),
        "");
    f.bound = core::Bound::kAtMost;
    f.unit = "deg";
    f.source = "docs/theory/cams.md, eq. 8b";
    f.suggestion = other_margin(part).or_else(shorter_law(part.cam, high));
    if (f.suggestion.empty())
        f.suggestion = fmt::format("another base spring: one whose contour has h'/h at most {:.2f} there",
                                   kInside * kLongestRunOut * at.rho / core::m_from_mm(maker.helix_radius_mm()));
    return {f};
}

}  // namespace fusee::solid
