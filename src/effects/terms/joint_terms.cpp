#include <cmath>

#include "terms.h"

namespace fusee::effects {

namespace {

EffectParameter joint_count() { return ripple_count(5.0, 4.0, 8.0); }

}  // namespace

std::vector<Term> joint_terms() {
    return {
        {{.id = "term.joint.spring",
          .law = "The joint has the torque -k q - h q^3 more.",
          .meaning = "A spring from the joint to ground, as wires to the hand.",
          .parameters = {{"rate", "Nm/rad", 0.1, {-1.0, 3.0}, 0.0}, {"hardening", "Nm/rad", 0.5, {-5.0, 20.0}, 0.0, {0.0, 1.0}}},
          .starts = {1.0, -1.0},
          .seen_by = moving_experiments(),
          .confused_with = {"joint.gravity"},
          .apply =
              [](BuiltRig& rig, int, std::span<const double> v) {
                  rig.terms.spring = v[0];
                  rig.terms.hardening = v[1];
              }},
         "joint",
         "angle",
         "joint_rad",
         "torque_Nm",
         [](std::span<const double> v, double x) { return -(v[0] + v[1] * x * x) * x; },
         "A spring of {size} Nm/rad acts between the joint and ground."},
        ripple_term({.id = "term.joint.ripple",
                     .law = "The joint has the torque a sin(n q + p) more.",
                     .meaning = "The torque at the joint ripples over its angle.",
                     .parameters = {{"amplitude", "Nm", 0.08, {-1.0, 1.0}, 0.0}, joint_count(), ripple_phase()},
                     .starts = {1.0},
                     .seen_by = moving_experiments(),
                     .confused_with = {},
                     .apply = [](BuiltRig& rig, int, std::span<const double> v) { rig.terms.torque = ripple_of(v); }},
                    "joint", "joint_rad", "torque_Nm", "The torque at the joint ripples {turns} times a turn, by {size} Nm."),
        {{.id = "term.joint.arm",
          .law = "The arms of both cables at the joint are (1 + a sin(n q + p)) times.",
          .meaning = "The pulley of the joint is off its centre or not round.",
          .parameters = {{"share", "1", 0.08, {-0.6, 0.6}, 0.0}, joint_count(), ripple_phase()},
          .starts = {1.0},
          .seen_by = moving_experiments(),
          .confused_with = {"figure.joint_radius"},
          .apply = [](BuiltRig& rig, int, std::span<const double> v) { rig.terms.arm = ripple_of(v); }},
         "joint",
         "angle",
         "joint_rad",
         "share",
         [](std::span<const double> v, double x) { return 1.0 + ripple_of(v)(x); },
         "The arms of the cables at the joint vary {turns} times a turn, by {share} %."},
        {{.id = "term.joint.rough_spot",
          .law = "The friction of the joint is h exp(-((q - q_0)/w)^2) higher.",
          .meaning = "The friction of the joint peaks at one angle: a dent of its bearing.",
          .parameters = {{"height", "Nm", 0.15, {0.0, 2.0}, 0.0},
                         {"at", "rad", 0.3, {-3.0, 3.0}, 0.0, {-0.5, -0.3, -0.15, 0.0, 0.15, 0.3, 0.5}},
                         {"width", "rad", 0.1, {0.01, 1.0}, 0.1, {0.1, 0.3}}},
          .starts = {1.0},
          .seen_by = moving_experiments(),
          .confused_with = {"joint.coulomb"},
          .apply =
              [](BuiltRig& rig, int, std::span<const double> v) {
                  rig.terms.friction = {v[0], v[1], v[2]};
              }},
         "joint",
         "angle",
         "joint_rad",
         "torque_Nm",
         [](std::span<const double> v, double x) {
             return joint_model::Bump{v[0], v[1], v[2]}(x);
         },
         "The friction of the joint is {size} Nm higher near {second} rad."},
        {{.id = "term.joint.drag",
          .law = "The torque of the joint is c |q'|^n lower in the direction of its motion.",
          .meaning = "The drag of the joint grows with a power of its speed: 2 in a fluid.",
          .parameters = {{"drag", "Nm", 0.05, {0.0, 5.0}, 0.0}, {"power", "1", 1.0, {0.3, 3.0}, 2.0, {0.5, 2.0}}},
          .starts = {1.0},
          .seen_by = moving_experiments(),
          .confused_with = {"joint.viscous", "joint.coulomb", "figure.joint_viscous"},
          .apply =
              [](BuiltRig& rig, int, std::span<const double> v) {
                  rig.terms.drag = v[0];
                  rig.terms.drag_power = v[1];
              }},
         "joint",
         "speed",
         "rad_per_s",
         "torque_Nm",
         [](std::span<const double> v, double x) { return v[0] * std::pow(std::abs(x), v[1]); },
         "The drag of the joint is {size} Nm at 1 rad/s and grows with the power {second} of its speed."},
        {{.id = "term.joint_encoder.flexibility",
          .law = "The encoder of the joint reads q + c tau_q.",
          .meaning = "The link bends between the encoder of the joint and the torque on it.",
          .parameters = {{"compliance", "1/Nm", 0.04, {-2.0, 2.0}, 0.0}},
          .starts = {1.0, 4.0, 12.0, -1.0},
          .seen_by = {Experiment::kJointStiffness, Experiment::kLog},
          .confused_with = {},
          .apply = [](BuiltRig& rig, int, std::span<const double> v) { rig.terms.flexibility = v[0]; }},
         "joint encoder",
         "load",
         "torque_Nm",
         "rad",
         [](std::span<const double> v, double x) { return v[0] * x; },
         "The encoder of the joint is {size} rad/Nm softer than the joint it shows."},
        {{.id = "term.joint_encoder.lag",
          .law = "The encoder of the joint reads q of a time T before, in a log.",
          .meaning = "The channel of the joint is late in a log: clocks that differ.",
          .parameters = {{"time", "s", 0.03, {0.0, 0.5}, 0.0}},
          .starts = {1.0, 2.5},
          .seen_by = {Experiment::kLog},
          .confused_with = {"loop.delay"},
          .apply = [](BuiltRig& rig, int, std::span<const double> v) { rig.terms.lag = v[0]; }},
         "joint encoder",
         "time",
         "time_s",
         "s",
         [](std::span<const double> v, double x) { return 0.0 * x + v[0]; },
         "The encoder of the joint is {size} s late in a log."},
        {{.id = "term.joint_encoder.scale",
          .law = "The encoder of the joint reads (1 + e) q.",
          .meaning = "The encoder of the joint counts too many or too few.",
          .parameters = {{"share", "1", 0.1, {-0.6, 0.6}, 0.0}},
          .starts = {0.7, -0.7},
          .seen_by = moving_experiments(),
          .confused_with = {"figure.joint_radius"},
          .apply = [](BuiltRig& rig, int, std::span<const double> v) { rig.terms.reading = v[0]; }},
         "joint encoder",
         "angle",
         "joint_rad",
         "rad",
         [](std::span<const double> v, double x) { return v[0] * x; },
         "The encoder of the joint reads {share} % too much."},
        {{.id = "term.joint_encoder.drift",
          .law =
              "The encoder of the joint reads q + d (1 - exp(-t/T)) at the time t of a session that makes the experiments in the format's "
              "order.",
          .meaning = "The zero of the joint's encoder moves as the session goes on: a holder that warms.",
          .parameters = drift("shift", "rad", 0.05, {-0.5, 0.5}),
          .starts = {1.0, -1.0},
          .seen_by = moving_experiments(),
          .confused_with = {"sensor.joint_offset"},
          .apply = [](BuiltRig& rig, int, std::span<const double> v) { rig.terms.zero = drift_of(v); }},
         "joint encoder",
         "time",
         "session_s",
         "rad",
         [](std::span<const double> v, double x) { return drift_of(v)(x); },
         "The zero of the joint's encoder moves by {size} rad over the session, with a time constant of {second} s."},
        {{.id = "term.joint_encoder.play",
          .law = "The link, which the encoder of the joint reads, turns freely by b on the pulley.",
          .meaning = "The link has play on the shaft of the joint: a worn key.",
          .parameters = {{"play", "rad", 0.05, {0.0, 0.5}, 0.0}},
          .starts = {0.6, 1.5},
          .seen_by = moving_experiments(),
          .confused_with = {},
          .apply = [](BuiltRig& rig, int, std::span<const double> v) { rig.terms.play = v[0]; }},
         "joint encoder",
         "history",
         "torque_Nm",
         "rad",
         [](std::span<const double> v, double x) { return x > 0.0   ? 0.5 * v[0]
                                                          : x < 0.0 ? -0.5 * v[0]
                                                                    : 0.0; },
         "The link has a play of {size} rad on the pulley of the joint."},
    };
}

}  // namespace fusee::effects
