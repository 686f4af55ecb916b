#include <fmt/format.h>

#include "fusee/core/units.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

constexpr double kDead_deg = 30.0;  // always wound

core::Findings measure_joint_winding(const Assembly& assembly, const Allowed& allowed) {
    const double turn = core::deg_from_rad(assembly.greatest_turn), joint = core::deg_from_rad(assembly.joint_range);
    const bool on_joint = joint > turn;
    core::Finding f = checks::judge(kDead_deg + std::max(turn, joint), {allowed("review")});
    f.what = fmt::format("cable wound on the {} in its last pose", on_joint ? "joint's pulley" : "capstan");
    f.where = on_joint ? "joint_pulley" : "capstan";
    f.suggestion = on_joint ? fmt::format("assembly.joint_range_deg = {}, with stops there", checks::down(f.allowed - kDead_deg))
                            : "a capstan with a helical groove of as many turns";
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
