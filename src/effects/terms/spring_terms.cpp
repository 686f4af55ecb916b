#include <algorithm>
#include <cmath>

#include "terms.h"

namespace fusee::effects {

namespace {

/// K_SE or K_PE in ids and in sentences.
struct SpringName {
    std::string id, name;
    [[nodiscard]] std::string effect(const char* what) const { return id.substr(2) + what; }
};

template <joint_model::SpringBuild joint_model::BuiltSide::*kBuild>
Term spring_step(const SpringName& spring) {
    return {{.id = "term." + spring.id + ".step",
             .law = "From one place of the cam on, its arm is (1 + a) times.",
             .meaning = "The arm of " + spring.name + " changes at one place of its cam: a crack or a dent.",
             .sided = true,
             .parameters = {{"share", "1", 0.15, {-0.9, 3.0}, 0.0}, {"at", "1", 0.3, {0.02, 0.98}, 0.5, {0.2, 0.4, 0.6, 0.8}}},
             .starts = {1.0, -1.0},
             .seen_by = spring_experiments(),
             .confused_with = {spring.effect(".radius")},
             .apply =
                 [](BuiltRig& rig, int side, std::span<const double> v) {
                     (rig.sides[side].*kBuild).step = v[0];
                     (rig.sides[side].*kBuild).step_at = v[1];
                 }},
            spring.name,
            "angle",
            "end_share",
            "share",
            [](std::span<const double> v, double x) { return joint_model::SpringBuild{.step = v[0], .step_at = v[1]}.arm_factor(x); },
            "The arm of {side} " + spring.name + " is {share} % off from {second} of its cam's end on."};
}

template <joint_model::SpringTerms joint_model::BuiltSide::*kSpring>
Term spring_slope(const SpringName& spring) {
    return {{.id = "term." + spring.id + ".slope",
             .law = "The torque is (1 + a x/x_end) times.",
             .meaning = "The torque of " + spring.name + " is off by a share that grows with its deflection.",
             .sided = true,
             .parameters = {{"share", "1", 0.15, {-0.9, 3.0}, 0.0}},
             .starts = {1.0, -1.0},
             .seen_by = spring_experiments(),
             .confused_with = {spring.effect(".rate")},
             .apply = [](BuiltRig& rig, int side, std::span<const double> v) { (rig.sides[side].*kSpring).slope = v[0]; }},
            spring.name,
            "angle",
            "end_share",
            "share",
            [](std::span<const double> v, double x) { return joint_model::SpringTerms{.slope = v[0], .drift = {}}.factor(x); },
            "The torque of {side} " + spring.name + " is off by a share that grows with its deflection, to {share} % at the cam's end."};
}

template <joint_model::SpringTerms joint_model::BuiltSide::*kSpring>
Term spring_relaxation(const SpringName& spring) {
    return {{.id = "term." + spring.id + ".relaxation",
             .law = "A share a of the torque is lost with the time constant T; w = 0: from that of the law, w = 1: down to it.",
             .meaning = spring.name + " relaxes as it is held: a printed spring or a rope that creeps.",
             .sided = true,
             .parameters = {{"share", "1", 0.3, {-0.2, 0.9}, 0.0},
                            {"time", "s", 2.0, {0.05, 20.0}, 1.5, {0.5, 1.5, 5.0}},
                            {"fast", "1", 1.0, {0.0, 1.0}, 0.5, {0.0, 1.0}}},
             .starts = {1.0},
             .seen_by = spring_experiments(),
             .confused_with = {spring.effect(".hysteresis")},
             .apply =
                 [](BuiltRig& rig, int side, std::span<const double> v) {
                     (rig.sides[side].*kSpring).relaxation = v[0];
                     (rig.sides[side].*kSpring).relaxation_time = v[1];
                     (rig.sides[side].*kSpring).fast_share = v[2];
                 }},
            spring.name,
            "time",
            "time_s",
            "share",
            [](std::span<const double> v, double x) { return 1.0 + v[0] * v[2] + v[0] * std::expm1(-x / v[1]); },
            "{Side} " + spring.name + " loses {share} % of its torque with a time constant of {second} s."};
}

template <joint_model::SpringTerms joint_model::BuiltSide::*kSpring>
Term spring_drift(const SpringName& spring) {
    return share_drift(
        {.id = "term." + spring.id + ".drift",
         .law = "The torque",
         .meaning = "The torque of " + spring.name + " changes as the session goes on, held or not: a spring or cable that warms or fades.",
         .sided = true,
         .parameters = drift("share", "1", 0.2, {-0.8, 1.0}),
         .starts = {-1.0, 1.0},
         .seen_by = spring_experiments(),
         .confused_with = {spring.effect(".rate"), spring.effect(".radius")},
         .apply = [](BuiltRig& rig, int side, std::span<const double> v) { (rig.sides[side].*kSpring).drift = drift_of(v); }},
        spring.name, "torque of {side} " + spring.name);
}

template <joint_model::SpringBuild joint_model::BuiltSide::*kBuild, joint_model::SpringTerms joint_model::BuiltSide::*kSpring>
std::vector<Term> terms_of(const SpringName& spring) {
    return {spring_step<kBuild>(spring), spring_slope<kSpring>(spring), spring_relaxation<kSpring>(spring), spring_drift<kSpring>(spring)};
}

Term cable_slip() {
    return {{.id = "term.cable.slip",
             .law = "Above the torque F_0 the cable slips by (F - F_0)/d, and does not come back.",
             .meaning = "The cable of K_SE slips on its capstan.",
             .sided = true,
             .parameters = {{"torque", "Nm", 1.0, {0.02, 20.0}, 0.0}, {"drag", "Nms", 1.0, {0.05, 20.0}, 1.2, {0.4, 1.2}}},
             .starts = {0.4, 0.8, 1.3},
             .seen_by = moving_experiments(),
             .confused_with = {},
             .apply =
                 [](BuiltRig& rig, int side, std::span<const double> v) {
                     rig.sides[side].se_terms.slip_at = v[0];
                     rig.sides[side].se_terms.slip_drag = v[1];
                 }},
            "cable",
            "load and time",
            "torque_Nm",
            "rad_per_s",
            [](std::span<const double> v, double x) { return std::max(0.0, x - v[0]) / v[1]; },
            "{Side} cable slips on its capstan above {size} Nm."};
}

Term cable_jump() {
    return {{.id = "term.cable.jump",
             .law = "At the torque F_0 the cable loses an angle, once in a run.",
             .meaning = "The cable of K_SE leaves its groove for the next one.",
             .sided = true,
             .parameters = {{"torque", "Nm", 1.0, {0.02, 20.0}, 0.0}, {"lost", "rad", 0.15, {0.01, 2.0}, 0.2, {0.1, 0.3}}},
             .starts = {0.3, 0.6, 1.0},
             .seen_by = moving_experiments(),
             .confused_with = {"sensor.joint_offset"},
             .apply =
                 [](BuiltRig& rig, int side, std::span<const double> v) {
                     rig.sides[side].se_terms.jump_at = v[0];
                     rig.sides[side].se_terms.jump = v[1];
                 }},
            "cable",
            "load and time",
            "torque_Nm",
            "rad",
            [](std::span<const double> v, double x) { return x > v[0] ? v[1] : 0.0; },
            "{Side} cable leaves its groove at {size} Nm, and loses {second} rad."};
}

}  // namespace

std::vector<Term> spring_terms() {
    std::vector<Term> all = terms_of<&joint_model::BuiltSide::se_build, &joint_model::BuiltSide::se_terms>({"k_se", "K_SE"});
    for (Term& term : terms_of<&joint_model::BuiltSide::pe_build, &joint_model::BuiltSide::pe_terms>({"k_pe", "K_PE"}))
        all.push_back(std::move(term));
    all.push_back(cable_slip());
    all.push_back(cable_jump());
    return all;
}

}  // namespace fusee::effects
