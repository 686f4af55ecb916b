#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_pe_hysteresis() {
    return {.id = "pe.hysteresis",
            .law = "F_PE (1 + a z), z from -1 (unloading) to 1 (loading).",
            .meaning = "The torque of K_PE is higher by this share while loading and lower by this share while unloading.",
            .sided = true,
            .parameters = {{"a", "1", 0.12, {0, 0.6}, 0}},
            .starts = {0.6, 1.5},
            .seen_by = spring_experiments(),
            .confused_with = {"gear.load_friction"},
            .advice = "check the compression spring: coils or guide rub",
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) { rig.sides[side].pe_build.hysteresis += values[0]; }};
}

}  // namespace fusee::effects
