#include "figures.h"

#include <algorithm>

namespace fusee::effects {

namespace {

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

}  // namespace

std::vector<Effect> figure_effects() {
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

}  // namespace fusee::effects
