#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_cable_tension_friction() {
    return {.id = "cable.tension_friction",
            .law = "Friction at the joint in proportion to the cables' pull: c g (F_SE1 + F_SE2).",
            .meaning = "The cables rub at the joint in proportion to their tension.",
            .sided = false,
            .parameters = {{"c", "1", 0.12, {0, 0.8}, 0}},
            .starts = {0.4, 1.2},
            .seen_by = {Experiment::kDeadBand, Experiment::kJointStiffness, Experiment::kCocontraction, Experiment::kLog},
            .confused_with = {"joint.coulomb"},
            .advice = "check the pulley and bearing of the joint under load; the corrected profile includes this friction",
            .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.tension_friction += values[0]; }};
}

}  // namespace fusee::effects
