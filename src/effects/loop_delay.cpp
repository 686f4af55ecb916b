#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_loop_delay() {
    return {.id = "loop.delay",
            .law = "Commands of a log act with a delay.",
            .meaning = "A command acts with this delay.",
            .sided = false,
            .parameters = {{"t_d", "s", 0.02, {0, 0.2}, 0}},
            .starts = {0.5, 1.5},
            .seen_by = {Experiment::kLog},
            .confused_with = {"joint.viscous"},
            .advice = "check the controller: springs do not change a delay",
            .apply = [](BuiltRig& rig, int, std::span<const double> values) { rig.delay += values[0]; }};
}

}  // namespace fusee::effects
