#include <fmt/format.h>

#include "fusee/core/units.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

constexpr double kDead_deg = 30.0;  // always wound

/// Turns side by side: a helical groove. Or a law that ends earlier.
std::string capstan_change(const Assembly& assembly, double measured_deg, double allowed_deg) {
    constexpr double kPitch = 1.25;  // in cables (practice)
    const double turns = (measured_deg + 360.0 - allowed_deg) / 360.0, pitch = kPitch * assembly.cable_mm;
    return fmt::format(
        "a capstan with a helical groove of {:.2f} turns, {:.2g} mm apart, which is not modelled; or a law that ends at {} deg "
        "of the capstan",
        turns, pitch, checks::down(allowed_deg - kDead_deg));
}

core::Findings measure_joint_winding(const Assembly& assembly, const Allowed& allowed) {
    const double turn = core::deg_from_rad(assembly.greatest_turn), joint = core::deg_from_rad(assembly.joint_range);
    const bool on_joint = joint > turn;
    core::Finding f = checks::compare(kDead_deg + std::max(turn, joint), {allowed("review")});
    f.what = fmt::format("cable wound on the {} in its last pose", on_joint ? "joint's pulley" : "capstan");
    f.where = on_joint ? "joint_pulley" : "capstan";
    f.suggestion = on_joint ? core::change("assembly.joint_range_deg", checks::down(f.allowed - kDead_deg)).noted(", with stops there")
                            : core::Suggestion(capstan_change(assembly, f.measured, f.allowed));
    return {f};
}

}  // namespace

Rule joint_winding() {
    return {{"joint.winding",
             "a cable that winds onto itself or onto its anchor",
             "angle of the cable on capstan and joint pulley when it is wound most, with 30 deg that never unwind",
             "one turn less the anchor's 15 deg (practice)",
             {review(kAtMost, "deg", 345.0)}},
            measure_joint_winding};
}

}  // namespace fusee::assembly
