#include "terms.h"

namespace fusee::effects {

namespace {

constexpr double kMostCount = 20.0;

/// Amplitude, count and phase of a ripple over an angle.
std::vector<EffectParameter> ripple(const std::string& unit, double scale, double most, double most_count) {
    return {{"amplitude", unit, scale, {-most, most}, 0.0}, ripple_count(10.0, 8.0, most_count), ripple_phase()};
}

std::vector<Experiment> gear_experiments() {
    std::vector<Experiment> all = moving_experiments();
    all.push_back(Experiment::kBreakAway);
    return all;
}

}  // namespace

std::vector<Term> gear_terms() {
    return {
        ripple_term(
            {.id = "term.gear.ripple",
             .law = "Friction is (1 + a sin(n theta + p)) times.",
             .meaning = "The friction of the gear ripples over the angle of its capstan.",
             .sided = true,
             .parameters = ripple("1", 0.4, 1.5, kMostCount),
             .starts = {1.0},
             .seen_by = moving_experiments(),
             .confused_with = {},
             .apply = [](BuiltRig& rig, int side, std::span<const double> v) { rig.sides[side].gear.terms.friction = ripple_of(v); }},
            "gear", "capstan_rad", "share", "The friction of {side} gear ripples {turns} times a turn of its capstan, by {share} %."),
        share_drift(
            {.id = "term.gear.drift",
             .law = "Friction",
             .meaning = "The friction of the gear changes over the session: grease that warms, a gear that runs in.",
             .sided = true,
             .parameters = drift("share", "1", 0.4, {-0.8, 2.0}),
             .starts = {1.0, -1.0},
             .seen_by = gear_experiments(),
             .confused_with = {"gear.load_friction", "gear.stribeck"},
             .apply = [](BuiltRig& rig, int side, std::span<const double> v) { rig.sides[side].gear.terms.friction_drift = drift_of(v); }},
            "gear", "friction of {side} gear"),
        ripple_term({.id = "term.motor.ripple",
                     .law = "The motor torque has a sin(n theta + p) more.",
                     .meaning = "The torque of the motor ripples over the angle of its capstan.",
                     .sided = true,
                     .parameters = ripple("Nm", 0.04, 0.5, kMostCount),
                     .starts = {1.0},
                     .seen_by = moving_experiments(),
                     .confused_with = {},
                     .apply = [](BuiltRig& rig, int side, std::span<const double> v) { rig.sides[side].gear.terms.torque = ripple_of(v); }},
                    "motor", "capstan_rad", "torque_Nm",
                    "The torque of {side} motor ripples {turns} times a turn of its capstan, by {size} Nm."),
        {{.id = "term.motor.crosstalk",
          .law = "The motor torque has c times the command of the other motor more.",
          .meaning = "The command of the other motor leaks into the motor.",
          .sided = true,
          .parameters = {{"share", "1", 0.1, {-0.5, 0.5}, 0.0}},
          .starts = {0.7, -0.7},
          .seen_by = moving_experiments(),
          .confused_with = {"sensor.torque_scale"},
          .apply = [](BuiltRig& rig, int side, std::span<const double> v) { rig.sides[side].gear.terms.crosstalk = v[0]; }},
         "motor",
         "other motor",
         "torque_Nm",
         "torque_Nm",
         [](std::span<const double> v, double x) { return v[0] * x; },
         "{Side} motor also gets {share} % of the command of the other one."},
        share_drift(
            {.id = "term.motor.drift",
             .law = "The motor torque",
             .meaning = "The motor delivers less or more as the session goes on: a winding or a driver that warms.",
             .sided = true,
             .parameters = drift("share", "1", 0.2, {-0.8, 1.0}),
             .starts = {-1.0, 1.0},
             .seen_by = gear_experiments(),
             .confused_with = {"sensor.torque_scale", "motor.saturation"},
             .apply = [](BuiltRig& rig, int side, std::span<const double> v) { rig.sides[side].gear.terms.torque_drift = drift_of(v); }},
            "motor", "torque of {side} motor"),
        ripple_term(
            {.id = "term.capstan_encoder.ripple",
             .law = "The encoder of the capstan reads theta + e sin(n theta + p).",
             .meaning = "The encoder of the capstan ripples over its angle: a disc off its centre once a turn.",
             .sided = true,
             .parameters = ripple("rad", 0.08, 0.5, 5.0),
             .starts = {1.0},
             .seen_by = {Experiment::kCocontraction, Experiment::kLog},
             .confused_with = {"gear.backlash"},
             .apply = [](BuiltRig& rig, int side, std::span<const double> v) { rig.sides[side].gear.terms.reading = ripple_of(v); }},
            "capstan encoder", "capstan_rad", "rad", "The encoder of {side} capstan ripples {turns} times a turn, by {size} rad."),
    };
}

}  // namespace fusee::effects
