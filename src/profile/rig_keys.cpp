#include "key.h"

namespace fusee::profile {

namespace {

#define FIELD(member) \
    [](auto& p) -> auto& { return p.member; }

const char* const kArrangement = "rig.arrangement";
const char* const kFrictionTable = "rig.gear_friction_table";

/// A measured friction replaces the figures of the straight line.
std::vector<Key> friction_keys() {
    const auto straight = [](Key key) { return when(kFrictionTable, {""}, std::move(key)); };
    return {
        file(kFrictionTable, "measured gear friction: CSV in the profile's folder with load_Nm,friction_Nm",
             FIELD(rig.gear_friction_table.file)),
        straight(required(number("rig.gear_friction", kPure, within(0, 0.95),
                                 "mu: a resting capstan at motor torque tau carries loads from tau/(1+mu) to tau/(1-mu)",
                                 FIELD(rig.gear_friction)))),
        straight(number("rig.gear_friction_constant_Nm", kNm, within(0, 1e3), "part of the gear friction that does not depend on the load",
                        FIELD(rig.gear_friction_constant))),
        number("rig.gear_friction_rest_excess", kPure, within(0, 10), "s: at rest the gear friction is 1 + s times that in motion",
               FIELD(rig.gear_friction_rest_excess)),
        number("rig.joint_friction_Nm", kNm, within(0, 1e3), "of the joint's bearing; for simulate", FIELD(rig.joint_friction.constant)),
        number("rig.joint_tension_friction", kPure, within(0, 0.95),
               "c: the bearing's friction grows by c for each Nm that the cables pull with at the joint; for simulate",
               FIELD(rig.joint_friction.tension_share)),
    };
}

}  // namespace

std::vector<Key> rig_keys() {
    std::vector<Key> all{
        choice(kArrangement, {"pnrvsa", "series_elastic", "simple_antagonist", "quasi_antagonist", "bidirectional", "cross_coupled"},
               "arrangement of the springs; all but the paper's can only be simulated", FIELD(rig.arrangement)),
        when(kArrangement, {"series_elastic", "simple_antagonist", "quasi_antagonist", "bidirectional", "cross_coupled"},
             number("rig.position_stiffness_Nm_per_rad", kNmPerRad, within(0, 1e6), "of a position loop at each motor; 0 = torque control",
                    FIELD(rig.position_stiffness))),
        when(kArrangement, {"cross_coupled"},
             number("rig.cross_stretch_rad", kRad, within(-100, 100),
                    "stretch of the spring between the motors, here K_PE, before they turn", FIELD(rig.cross_stretch))),
        required(number("rig.capstan_radius_mm", kMm, above(0, 1000), "r_c, radius at which the capstan takes the joint's cable",
                        FIELD(rig.capstan_radius))),
        required(number("rig.joint_radius_mm", kMm, above(0, 1000), "r_j, radius of the joint's pulley", FIELD(rig.joint_radius))),
    };
    for (Key& key : friction_keys()) all.push_back(std::move(key));
    all.push_back(required(
        number("rig.least_torque_Nm", kNm, above(0, 1e4), "least co-contraction used; below the peak torque", FIELD(rig.least_torque))));
    all.push_back(
        required(number("rig.peak_torque_Nm", kNm, above(0, 1e4), "the motors' continuous torque at the capstan", FIELD(rig.peak_torque))));
    all.push_back(required(
        number("rig.overdrive_torque_Nm", kNm, above(0, 1e4), "for a short time; not below the peak torque", FIELD(rig.overdrive_torque))));
    return all;
}

#undef FIELD

}  // namespace fusee::profile
