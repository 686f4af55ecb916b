#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_hand(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const bool left = s.hand == spring::Hand::kLeft;
    core::Finding f = compare((left ? 1 : -1) * design.part.cam.rotation_sign, {allowed("required")});
    f.what =
        fmt::format("a {}-hand spring over the top face, {} by the part", left ? "left" : "right", f.measured > 0.0 ? "wound" : "unwound");
    f.suggestion = change(design, "spring.hand", quoted(left ? "right" : "left"))
                       .or_else(change(design, "torque_sign", number(-design.part.cam.options.torque_sign)));
    return {f};
}

}  // namespace

Rule spring_hand() {
    return {"spring.hand",
            "a torsion spring of the wrong hand",
            "sense in which the part turns the spring over its top face: 1 winds, -1 unwinds it",
            "geometry: a left-hand coil winds where its lower end turns counter-clockwise",
            {required(kAtLeast, "", 0.0)},
            measure_spring_hand,
            has_torsion_leg_slot,
            {need::kHand}};
}

}  // namespace fusee::checks
