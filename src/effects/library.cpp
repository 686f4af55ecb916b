#include <algorithm>
#include <iterator>

#include "fusee/effects/effect.h"

// The fault library: a row an effect, in the order of their ids.
namespace fusee::effects {

namespace {

std::vector<Effect> causes() {
    const std::vector<Experiment> of_gear{Experiment::kBreakAway, Experiment::kDeadBand, Experiment::kJointStiffness,
                                          Experiment::kCocontraction, Experiment::kLog};
    return {
        {.id = "cable.stretch",
         .law = "Compliance in series with K_SE.",
         .meaning = "The cable stretches in series with K_SE: together they are softer than designed.",
         .sided = true,
         .parameters = {{"k_c", "Nm/rad", 1.0, {0.05, 1000}, 0}},
         .starts = {0.5, 1, 2.5, 8},
         .seen_by = spring_experiments(),
         .confused_with = {"se.rate", "se.radius"},
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].se_build.stretch += 1.0 / values[0]; }},
        {.id = "cable.tension_friction",
         .law = "Friction at the joint in proportion to the cables' pull: c g (F_SE1 + F_SE2).",
         .meaning = "The cables rub at the joint in proportion to their tension.",
         .parameters = {{"c", "1", 0.12, {0, 0.8}, 0}},
         .starts = {0.4, 1.2},
         .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
         .confused_with = {"joint.coulomb"},
         .advice = "check the pulley and bearing of the joint under load; the corrected profile includes this friction",
         .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.tension_friction += values[0]; }},
        {.id = "gear.asymmetry",
         .law = "Friction is (1 + a) times the nominal value when the motor winds in, (1 - a) times when it pays out.",
         .meaning = "The gear loses more when its load drives it back (+) or when its motor drives (-) than in the other direction.",
         .sided = true,
         .parameters = {{"a", "1", 0.3, {-0.9, 0.9}, 0}},
         .starts = {-1, -0.4, 0.4, 1},
         .seen_by = of_gear,
         .confused_with = {"gear.load_friction", "sensor.torque_scale"},
         .advice = "measure both directions by break-away tests: a profile has one friction for winding in and paying out",
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.asymmetry += values[0]; }},
        {.id = "gear.backlash",
         .law = "Play between the capstan and the encoder of its motor.",
         .meaning = "The gear has this much play before its teeth meet on the other side.",
         .sided = true,
         .parameters = {{"b", "rad", 0.03, {0, 0.5}, 0}},
         .starts = {0.5, 1.5},
         .seen_by = {Experiment::kCocontraction, Experiment::kLog},
         .confused_with = {},
         .advice = "remove the play in the gear or its coupling",
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.backlash += values[0]; }},
        {.id = "gear.coulomb",
         .law = "Constant friction in addition to mu tau_load.",
         .meaning = "The gear has a constant friction in addition to mu times the load, for example from a seal or a preloaded bearing.",
         .sided = true,
         .parameters = {{"tau_c", "Nm", 0.04, {0, 0.5}, 0}},
         .starts = {0.5, 1.5},
         .seen_by = of_gear,
         .confused_with = {"gear.load_friction", "gear.load_quadratic"},
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.coulomb += values[0]; }},
        {.id = "gear.load_friction",
         .law = "The friction coefficient differs from the nominal one: mu (1 + e).",
         .meaning = "The gear loses more (+) or less (-) of its load to friction than the nominal mu says.",
         .sided = true,
         .parameters = {{"e", "1", 0.25, {-0.9, 1.5}, 0}},
         .starts = {-2, -1, -0.4, 0.4, 1, 2},
         .seen_by = of_gear,
         .confused_with = {"gear.coulomb", "gear.stribeck", "gear.load_quadratic"},
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.load_friction *= 1.0 + values[0]; }},
        {.id = "gear.load_quadratic",
         .law = "Friction that grows with the load squared: b tau_load^2 in addition to mu tau_load.",
         .meaning = "The gear's friction grows faster than its load.",
         .sided = true,
         .parameters = {{"b", "1/Nm", 0.08, {-0.1, 0.4}, 0}},
         .starts = {-0.7, 0.7, 1.5},
         .seen_by = of_gear,
         .confused_with = {"gear.load_friction", "gear.coulomb"},
         .advice = "measure the friction by break-away tests and name the table in rig.gear_friction_table",
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.quadratic += values[0]; }},
        {.id = "gear.stribeck",
         .law = "Friction at rest is (1 + s) times that in motion; it falls as s exp(-(v/v_s)^2).",
         .meaning = "The gear friction is larger at rest than in motion: the gear sticks, then slips.",
         .sided = true,
         .parameters = {{"s", "1", 0.6, {0, 3}, 0}, {"v_s", "rad/s", 0.06, {0.005, 0.5}, 0.06, {0.03, 0.1, 0.25}}},
         .starts = {0.5, 1.5},
         .seen_by = of_gear,
         .confused_with = {"gear.load_friction"},
         .apply =
             [](BuiltRig& rig, int side, std::span<const double> values) {
                 rig.sides[side].gear.stribeck += values[0];
                 rig.sides[side].gear.stribeck_speed = values[1];
             }},
        {.id = "gear.viscous",
         .law = "Extra viscous drag at the capstan.",
         .meaning = "The gear friction grows with speed, for example in stiff grease.",
         .sided = true,
         .parameters = {{"d", "Nms", 0.05, {0, 1}, 0}},
         .starts = {0.5, 1.5},
         .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
         .confused_with = {"joint.viscous"},
         .advice = "move slower or change the grease; the corrected profile includes this friction",
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.viscous += values[0]; }},
        {.id = "joint.coulomb",
         .law = "Constant friction at the joint.",
         .meaning = "The joint's bearing has a constant friction.",
         .parameters = {{"tau_c", "Nm", 0.07, {0, 0.6}, 0}},
         .starts = {0.4, 1.2},
         .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
         .confused_with = {"cable.tension_friction", "joint.viscous"},
         .advice = "check the joint bearing: alignment, preload, seals; the corrected profile includes this friction",
         .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.joint_coulomb += values[0]; }},
        {.id = "joint.gravity",
         .law = "Weight of the link: torque -m g l sin q.",
         .meaning = "The link's weight turns the joint: its centre of mass lies off the joint's axis.",
         .parameters = {{"mgl", "Nm", 0.15, {-1, 1.5}, 0}},
         .starts = {-1, 0.6, 1.5},
         .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
         .confused_with = {},
         .advice = "balance the joint, or mount it so that gravity has no lever arm",
         .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.gravity += values[0]; }},
        {.id = "joint.stop",
         .law = "A hard stop inside the modelled range limits |q|.",
         .meaning = "The joint meets a hard stop at this angle, inside the modelled range.",
         .parameters = {{"q_s", "rad", 0.5, {0.02, 4}, 0},
                        {"k_s", "Nm/rad", 50, {3, 500}, 60, {15, 60, 250}},
                        {"zeta", "1", 0.3, {0, 2}, 0.5}},
         .starts = {0.3, 0.6, 1, 1.5, 2.2, 3},
         .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kLog},
         .confused_with = {},
         .advice = "find the obstacle that the joint meets and remove it",
         .apply =
             [](BuiltRig& rig, int, std::span<const double> values) {
                 rig.stop = values[0];
                 rig.stop_stiffness = values[1];
                 rig.stop_damping = values[2];
             }},
        {.id = "joint.viscous",
         .law = "Extra viscous drag at the joint.",
         .meaning = "The joint friction grows with speed.",
         .parameters = {{"d", "Nms", 0.04, {0, 0.5}, 0}},
         .starts = {0.5, 1.5},
         .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
         .confused_with = {"joint.coulomb", "gear.viscous"},
         .advice = "check grease and seals of the joint; the corrected profile includes this friction",
         .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.joint_viscous += values[0]; }},
        {.id = "loop.delay",
         .law = "Commands of a log act with a delay.",
         .meaning = "A command acts with this delay.",
         .parameters = {{"t_d", "s", 0.02, {0, 0.2}, 0}},
         .starts = {0.5, 1.5},
         .seen_by = {Experiment::kLog},
         .confused_with = {"joint.viscous"},
         .advice = "check the controller: springs do not change a delay",
         .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.delay += values[0]; }},
        {.id = "motor.saturation",
         .law = "The motor torque is limited.",
         .meaning = "The motor delivers at most this torque.",
         .sided = true,
         .parameters = {{"tau_max", "Nm", 0.8, {0.1, 5}, 0}},
         .starts = {0.6, 1, 1.4},
         .seen_by = of_gear,
         .confused_with = {"sensor.torque_scale"},
         .advice = "command less torque, or use a stronger motor",
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.saturation = values[0]; }},
        {.id = "pe.bottoming",
         .law = "The coils of the compression spring bind beyond a compression y_b.",
         .meaning = "The coils of the compression spring of K_PE bind beyond this compression.",
         .sided = true,
         .parameters = {{"y_b", "m", 0.016, {0.002, 0.06}, 0}, {"rate", "1", 10, {1, 60}, 15}},
         .starts = {0.4, 0.6, 0.8, 1, 1.2, 1.5},
         .seen_by = spring_experiments(),
         .confused_with = {},
         .advice = "use a compression spring with more travel to solid (k_pe.spring.max_travel_mm)",
         .apply =
             [](BuiltRig& rig, int side, std::span<const double> values) {
                 rig.sides[side].pe_build.binds_at = values[0];
                 rig.sides[side].pe_build.binding_rate = values[1];
             }},
        {.id = "pe.hysteresis",
         .law = "F_PE (1 + a z), z from -1 (unloading) to 1 (loading).",
         .meaning = "The torque of K_PE is higher by this share while loading and lower by this share while unloading.",
         .sided = true,
         .parameters = {{"a", "1", 0.12, {0, 0.6}, 0}},
         .starts = {0.6, 1.5},
         .seen_by = spring_experiments(),
         .confused_with = {"gear.load_friction"},
         .advice = "check the compression spring: coils or guide rub",
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].pe_build.hysteresis += values[0]; }},
        {.id = "pe.preload",
         .law = "K_PE's base spring starts compressed (+) or slack (-).",
         .meaning = "The base spring of K_PE starts compressed (+) or slack (-).",
         .sided = true,
         .parameters = {{"y_0", "m", 0.002, {-0.01, 0.01}, 0}},
         .starts = {-1, 1},
         .seen_by = spring_experiments(),
         .confused_with = {"pe.radius"},
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].pe_build.preload += values[0]; }},
        {.id = "pe.radius",
         .law = "Every arm of K_PE's cam is longer or shorter.",
         .meaning = "Every arm of K_PE's cam is longer (+) or shorter (-): cable thickness, over- or under-cut, shrinkage.",
         .sided = true,
         .parameters = {{"dr", "m", 0.001, {-0.004, 0.004}, 0}},
         .starts = {-1, 1},
         .seen_by = spring_experiments(),
         .confused_with = {"pe.rate"},
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].pe_build.radius += values[0]; }},
        {.id = "pe.rate",
         .law = "The rate of K_PE's base spring differs from the nominal one: k (1 + e).",
         .meaning = "The base spring of K_PE is stiffer (+) or softer (-) than its nominal rate.",
         .sided = true,
         .parameters = {{"e", "1", 0.12, {-0.6, 1}, 0}},
         .starts = {-1, 1},
         .seen_by = spring_experiments(),
         .confused_with = {"pe.radius"},
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].pe_build.rate += values[0]; }},
        {.id = "se.hysteresis",
         .law = "F_SE (1 + a z), z from -1 (unloading) to 1 (loading).",
         .meaning = "The torque of K_SE is higher by this share while loading and lower by this share while unloading.",
         .sided = true,
         .parameters = {{"a", "1", 0.1, {0, 0.6}, 0}},
         .starts = {0.6, 1.5},
         .seen_by = spring_experiments(),
         .confused_with = {"gear.load_friction"},
         .advice = "check the torsion spring: coils rub or a leg slips",
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].se_build.hysteresis += values[0]; }},
        {.id = "se.preload",
         .law = "K_SE's base spring starts wound (+) or slack (-).",
         .meaning = "The base spring of K_SE starts wound (+) or slack (-).",
         .sided = true,
         .parameters = {{"phi_0", "rad", 0.22, {-1.5, 1.5}, 0}},
         .starts = {-1, 1},
         .seen_by = spring_experiments(),
         .confused_with = {},
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].se_build.preload += values[0]; }},
        {.id = "se.radius",
         .law = "Every arm of K_SE's spool is longer or shorter.",
         .meaning = "Every arm of K_SE's spool is longer (+) or shorter (-): cable thickness, over- or under-cut, shrinkage.",
         .sided = true,
         .parameters = {{"dr", "m", 0.0015, {-0.006, 0.006}, 0}},
         .starts = {-1, 1},
         .seen_by = spring_experiments(),
         .confused_with = {"se.rate"},
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].se_build.radius += values[0]; }},
        {.id = "se.rate",
         .law = "The rate of K_SE's base spring differs from the nominal one: k (1 + e).",
         .meaning = "The base spring of K_SE is stiffer (+) or softer (-) than its nominal rate.",
         .sided = true,
         .parameters = {{"e", "1", 0.12, {-0.6, 1}, 0}},
         .starts = {-1, 1},
         .seen_by = spring_experiments(),
         .confused_with = {"se.radius", "cable.stretch"},
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].se_build.rate += values[0]; }},
        {.id = "sensor.joint_offset",
         .law = "The zero of the joint encoder is displaced.",
         .meaning = "The zero of the joint encoder is displaced by this angle.",
         .parameters = {{"q_0", "rad", 0.05, {-1, 1}, 0}},
         .starts = {-1, 1},
         .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
         .confused_with = {},
         .advice = "set the zero of the joint encoder",
         .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.joint_offset += values[0]; }},
        {.id = "sensor.torque_scale",
         .law = "The torque delivered is (1 + e) times the one commanded.",
         .meaning = "The delivered torque differs from the command by this share, for example because of a wrong motor constant.",
         .sided = true,
         .parameters = {{"e", "1", 0.15, {-0.6, 1}, 0}},
         .starts = {-1, 1},
         .seen_by = of_gear,
         .confused_with = {"gear.asymmetry"},
         .advice = "calibrate the motor torque; new cams do not help",
         .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].gear.torque_scale += values[0]; }},
    };
}

using Apply = void (*)(BuiltRig&, int, std::span<const double>);

/// A figure of case.toml whose deviation the motions show.
Effect figure(const char* id, const char* law, const char* meaning, const EffectParameter& deviation, Apply apply) {
    return {.id = id,
            .law = law,
            .meaning = meaning,
            .parameters = {deviation},
            .starts = {},
            .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
            .confused_with = {},
            .advice = "Measure it, and put the measured figure into case.toml.",
            .figure = true,
            .apply = apply};
}

Effect radius(const char* id, const char* law, const char* meaning, Apply apply) {
    Effect own = figure(id, law, meaning, {"e", "1", 0.03, {-0.3, 0.3}, 0}, apply);
    own.sided = true;
    own.starts = {-0.7, 0.7};
    return own;
}

Effect inertia(const char* id, const char* law, const char* meaning, bool sided, Apply apply) {
    Effect own = figure(id, law, meaning, {"e", "1", 0.3, {-0.8, 4}, 0}, apply);
    own.sided = sided;
    own.starts = {-1.5, 1, 3};
    own.confused_with = {"loop.delay"};
    return own;
}

/// Less drag than stated, at the usual size of gear.viscous or joint.viscous, which are more of it.
Effect drag(const char* id, const char* law, const char* meaning, double usual, Apply apply) {
    Effect own = figure(id, law, meaning, {"d", "Nms", usual, {-0.3, 0}, 0}, apply);
    own.starts = {-0.15};
    return own;
}

/// A figure of [rig] in case.toml is not what was stated, by a share of what was stated. Figures of springs, gear friction, preloads and
/// zeros are above, with effects of the same law.
std::vector<Effect> figures() {
    return {
        radius("figure.joint_radius", "The joint's radius over that of the capstan is (1 + e) times the stated one.",
               "The joint's radius is not what case.toml states.",
               [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].ratio *= 1.0 + values[0]; }),
        inertia("figure.motor_inertia", "The motor's inertia is (1 + e) times the stated one.",
                "The motor's inertia is not what case.toml states.", true,
                [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].motor_inertia *= 1.0 + values[0]; }),
        inertia("figure.joint_inertia", "The joint's inertia is (1 + e) times the stated one.",
                "The joint's inertia is not what case.toml states.", false,
                [](BuiltRig& rig, int, std::span<const double> values) { rig.joint_inertia *= 1.0 + values[0]; }),
        drag("figure.motor_viscous", "The drag of both motors differs from the stated one by d <= 0, to no less than none.",
             "The motors' viscous drag is less than case.toml states.", 0.05,
             [](BuiltRig& rig, int, std::span<const double> values) {
                 for (joint_model::BuiltSide& side : rig.sides) side.gear.viscous = std::max(0.0, side.gear.viscous + values[0]);
             }),
        drag("figure.joint_viscous", "The drag of the joint differs from the stated one by d <= 0, to no less than none.",
             "The joint's viscous drag is less than case.toml states.", 0.04,
             [](BuiltRig& rig, int, std::span<const double> values) { rig.joint_viscous = std::max(0.0, rig.joint_viscous + values[0]); }),
    };
}

}  // namespace

const std::vector<Effect>& effect_library() {
    static const std::vector<Effect> library = [] {
        std::vector<Effect> all = causes();
        std::ranges::move(figures(), std::back_inserter(all));
        return all;
    }();
    return library;
}

}  // namespace fusee::effects
