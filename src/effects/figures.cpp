#include "figures.h"

#include <algorithm>

namespace fusee::effects {

namespace {

const char* const kAdvice = "Measure it, and put the measured figure into case.toml.";

std::vector<Experiment> motions() {
    return {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog};
}

Effect radius(const char* id, const char* law, const char* meaning, void (*apply)(BuiltRig&, int, std::span<const double>)) {
    return {.id = id,
            .law = law,
            .meaning = meaning,
            .sided = true,
            .parameters = {{"e", "1", 0.03, {-0.3, 0.3}, 0}},
            .starts = {-0.7, 0.7},
            .seen_by = motions(),
            .confused_with = {},
            .advice = kAdvice,
            .figure = true,
            .apply = apply};
}

Effect inertia(const char* id, const char* law, const char* meaning, bool sided, void (*apply)(BuiltRig&, int, std::span<const double>)) {
    return {.id = id,
            .law = law,
            .meaning = meaning,
            .sided = sided,
            .parameters = {{"e", "1", 0.3, {-0.8, 4}, 0}},
            .starts = {-1.5, 1, 3},
            .seen_by = motions(),
            .confused_with = {"loop.delay"},
            .advice = kAdvice,
            .figure = true,
            .apply = apply};
}

/// Less drag than stated, at the usual size of gear.viscous or joint.viscous, which are more of it.
Effect drag(const char* id, const char* law, const char* meaning, double usual, void (*apply)(BuiltRig&, int, std::span<const double>)) {
    return {.id = id,
            .law = law,
            .meaning = meaning,
            .sided = false,
            .parameters = {{"d", "Nms", usual, {-0.3, 0}, 0}},
            .starts = {-0.15},
            .seen_by = motions(),
            .confused_with = {},
            .advice = kAdvice,
            .figure = true,
            .apply = apply};
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
