#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_sla_support(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kSla || design.part.section.size() < 2) return {};
    core::Finding f = compare(deg_from_rad(largest_overhang(design.part)), {allowed("review")});
    f.what = "angle of the groove's upper flank from the vertical; above the limit it needs supports where the cable runs";
    f.where = along_groove(design);
    f.suggestion = change("groove.throat_deg", number(180.0 - 2.0 * f.allowed));
    return {f};
}

}  // namespace

Rule sla_support() {
    return on_cable(
        {"sla.support",
         "supports that scar the groove",
         "SLA, axis upright: angle of the groove's upper flank from the vertical",
         "addema, iamrapid: guides for SLA: faces without support at least 19 deg from level; addema adds that they be shorter than 1 mm, "
         "which this rule does not judge",
         {review(kAtMost, "deg", 71.0)},
         measure_sla_support});
}

}  // namespace fusee::checks
