#include "key.h"

namespace fusee::profile {

namespace {

const char* const kArrangement = "rig.arrangement";
const char* const kFrictionTable = "rig.gear_friction_table";

/// A measured friction replaces the figures of the straight line.
std::vector<Key> friction_keys() {
    const auto straight = [](Key key) { return when(kFrictionTable, {""}, std::move(key)); };
    return {
        file(kFrictionTable, "measured gear friction: CSV in the profile's folder with load_Nm,friction_Nm",
             FIELD(rig.gear_friction_table.file)),
        straight(required(number("rig.gear_friction", within(0, 0.95),
                                 "mu: a resting capstan at motor torque tau carries loads from tau/(1+mu) to tau/(1-mu)",
                                 FIELD(rig.gear_friction)))),
        straight(number("rig.gear_friction_constant_Nm", within(0, 1e3), "part of the gear friction that does not depend on the load",
                        FIELD(rig.gear_friction_constant))),
        number("rig.gear_friction_rest_excess", within(0, 10), "s: at rest the gear friction is 1 + s times that in motion",
               FIELD(rig.gear_friction_rest_excess)),
        number("rig.joint_friction_Nm", within(0, 1e3), "of the joint's bearing; for simulate", FIELD(rig.joint_friction.constant)),
        number("rig.joint_tension_friction", within(0, 0.95),
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
             number("rig.position_stiffness_Nm_per_rad", within(0, 1e6), "of a position loop at each motor; 0 = torque control",
                    FIELD(rig.position_stiffness))),
        when(kArrangement, {"cross_coupled"},
             number("rig.cross_stretch_rad", within(-100, 100), "stretch of the spring between the motors, here K_PE, before they turn",
                    FIELD(rig.cross_stretch))),
        required(number("rig.capstan_radius_mm", above(0, 1000), "r_c, radius at which the capstan takes the joint's cable",
                        FIELD(rig.capstan_radius))),
        required(number("rig.joint_radius_mm", above(0, 1000), "r_j, radius of the joint's pulley", FIELD(rig.joint_radius))),
    };
    for (Key& key : friction_keys()) all.push_back(std::move(key));
    all.push_back(required(
        number("rig.least_torque_Nm", above(0, 1e4), "least co-contraction used; below the peak torque", FIELD(rig.least_torque))));
    all.push_back(
        required(number("rig.peak_torque_Nm", above(0, 1e4), "the motors' continuous torque at the capstan", FIELD(rig.peak_torque))));
    all.push_back(required(
        number("rig.overdrive_torque_Nm", above(0, 1e4), "for a short time; not below the peak torque", FIELD(rig.overdrive_torque))));
    return all;
}

std::vector<Key> simulation_keys() {
    const Limits inertia = above(0, 1e4), viscous = above(0, 1e6), noise = within(0, 1e6);
    return {
        number("dynamics.motor_inertia_kgm2", inertia, "of motor and gear at the capstan; default assumed", FIELD(dynamics.motor_inertia)),
        number("dynamics.joint_inertia_kgm2", inertia, "of the moved link; default assumed", FIELD(dynamics.joint_inertia)),
        number("dynamics.motor_viscous_Nms", viscous, "drag per rad/s at the capstan; default assumed", FIELD(dynamics.motor_viscous)),
        number("dynamics.joint_viscous_Nms", viscous, "drag per rad/s at the joint; default assumed", FIELD(dynamics.joint_viscous)),
        number("dynamics.motor_noise_Nm2s", noise, "spectral density (two-sided) of white torque noise at each capstan; default assumed",
               FIELD(dynamics.motor_noise)),
        number("dynamics.joint_noise_Nm2s", noise, "the same at the joint; default assumed", FIELD(dynamics.joint_noise)),
        integer("simulate.levels", within(2, 1000), "levels of co-contraction, from least to overdrive torque", FIELD(simulate.levels)),
        number("simulate.push_torque_Nm", within(0, 1e4), "of the push-and-release test, at the joint; 0 = strong enough",
               FIELD(simulate.push_torque)),
        file("simulate.measured", "measured dead-band: CSV in the profile's folder with tau_Nm,width_deg (full width at the joint)",
             FIELD(simulate.measured.file)),
    };
}

std::vector<Key> budget_keys() {
    const Limits share = within(0, 50);
    return {
        number("budget.runout_mm", within(0, 10), "of a cam's axis on its shaft; 0 = half of the bore's clearance", FIELD(budget.runout)),
        number("budget.guide_mm", within(0, 100), "of a hole or idler, across its cable; of a follower's line, sideways",
               FIELD(budget.guide)),
        number("budget.guide_deg", within(0, 45), "of a parallel exit", FIELD(budget.direction)),
        number("budget.rate_percent", share, "of a base spring's rate; Lee Spring, springs3d: 10 for bought springs", FIELD(budget.rate)),
        number("budget.measured_rate_percent", share, "of a rate whose rate_origin is \"measured\"", FIELD(budget.measured_rate)),
        number("budget.preload_percent", share, "of the base spring's state at the law's lowest load", FIELD(budget.preload)),
        number("budget.cable_percent", share, "of the cable's diameter", FIELD(budget.cable)),
        number("budget.zero_deg", within(0, 45),
               "of the capstan's angle, or a single spring's, against its cams: timing marks, knots, encoder", FIELD(budget.zero)),
        all_of(Key::Of::kJoint, {number("budget.friction_percent", share, "of a gear's friction", FIELD(budget.friction))}).front(),
    };
}

std::vector<Key> assembly_keys() {
    return {
        number("assembly.motor_distance_mm", or_zero(1, 10000),
               "joint's axis to the motors' axes, along the cables; 0 = the least that the bodies need", FIELD(assembly.motor_distance)),
        number("assembly.k_pe_direction_deg", within(-360, 360),
               "in which the agonist's K_PE pulls its cable off its motor's axis; 90 = towards the joint, 0 = outwards",
               FIELD(assembly.k_pe_direction)),
        number("assembly.joint_range_deg", or_zero(1, 720),
               "of the joint between its stops; 0 = what the springs and one turn of cable allow", FIELD(assembly.joint_range)),
        number("assembly.gap_mm", within(0.01, 1000), "between bodies that move against each other, where the layout places them",
               FIELD(assembly.gap)),
        yes_or_no("assembly.frame", "with a plate and brackets that hold what is fixed", FIELD(assembly.frame)),
        number("assembly.wall_mm", within(0.1, 1000), "of the carriage and of the plate under K_PE's spring", FIELD(assembly.wall)),
    };
}

}  // namespace fusee::profile
