#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/checks/limits.h"
#include "layout.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

constexpr double kStraight = core::rad_from_deg(1.5);  // a cable that is bent by less runs straight through a smooth hole
constexpr int kPoses = 33;
constexpr double kRopeBend = 3.0;  // D/d of a fibre rope that is deflected

/// Largest angle by which an agonist's cable bends at its guide, over the working range [rad].
double deflection(const Assembly& a, CableKind kind) {
    double most = 0.0;
    for (int i = 0; i < kPoses; ++i) {
        const double share = i / (kPoses - 1.0);
        const Pose pose{{share * a.greatest_turn, share * a.greatest_payout_mm}, {}};
        const double along = kind == CableKind::kSeries ? 0.5 * core::kPi : a.options.k_pe_direction;
        for (const FreeCable& cable : free_cables(a, pose)) {
            if (cable.kind != kind || cable.side != Side::kAgonist) continue;
            const Eigen::Vector3d from = (cable.to_mm - cable.from_mm).normalized(), to(std::cos(along), std::sin(along), 0.0);
            most = std::max(most, std::acos(std::clamp(from.dot(to), -1.0, 1.0)));
        }
    }
    return most;
}

core::Suggestion softer_bend(const Assembly& a, const std::string& part, double allowed) {
    const double radius = 0.5 * allowed * a.cable_mm;
    if (radius > guide_edge_mm(a.cable_mm, INFINITY))
        return core::change(part + ".guide.kind", core::quoted("idler"))
            .with(part + ".guide.radius_mm", checks::up(radius + 0.5 * a.cable_mm));
    return core::change("assembly.wall_mm", checks::up(2.0 * radius));
}

core::Findings measure_joint_guide_edge(const Assembly& a, const Allowed& allowed) {
    const checks::CableLimits& cable = checks::cable_limits(a.drive.cable.construction);
    const double edge = guide_edge_mm(a.cable_mm, core::mm_from_m(a.options.wall));
    core::Findings all;
    for (const auto& [kind, part, body] : {std::tuple(CableKind::kSeries, a.drive.k_se.get(), "carriage"),
                                           std::tuple(CableKind::kParallel, a.drive.k_pe.get(), "k_pe_seat")}) {
        const double bend = deflection(a, kind);
        if (part->cam.options.guide.kind == cam::GuideKind::kIdler || bend <= kStraight) continue;
        core::Finding f = checks::compare(2.0 * edge / a.cable_mm,
                                          {allowed("required"), allowed("review", cable.is_fibre() ? kRopeBend : cable.critical)});
        f.what =
            fmt::format("D/d of the {} cable, which bends by {:.1f} deg over the edge of its guide's hole, rounded by hand to {:.3g} mm",
                        to_string(kind), core::deg_from_rad(bend), edge);
        f.where = body;
        f.suggestion = softer_bend(a, to_string(part->cam.kind), f.allowed);
        all.push_back(std::move(f));
    }
    return all;
}

}  // namespace

Rule joint_guide_edge() {
    return {
        {"joint.guide_edge",
         "a cable that frays on the edge of its guide's hole",
         "D/d over the edge of the hole in carriage and seat, which is rounded to 1.5 cables or half of their wall; where the cable bends "
         "by more than 1.5 deg",
         "Samson: D/d 3 where a rope is deflected; wire: the critical D/d of table 1; Sava: half the strength is left at D/d 1, the end of "
         "its table; 1.5 deg: a smooth drum's fleet (wirerope.net)",
         {required(kAtLeast, "", 1.0), review(kAtLeast, "", "3 for fibre, the critical D/d for wire (table 1)")}},
        measure_joint_guide_edge};
}

}  // namespace fusee::assembly
