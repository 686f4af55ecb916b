#include "fusee/effects/effect.h"

namespace fusee::effects {

Effect make_pe_bottoming() {
    return {.id = "pe.bottoming",
            .law = "The coils of the compression spring bind beyond a compression y_b.",
            .meaning = "The coils of the compression spring of K_PE bind beyond this compression.",
            .sided = true,
            .parameters = {{"y_b", "m", 0.016, {0.002, 0.06}, 0}, {"rate", "1", 10, {1, 60}, 15}},
            .starts = {0.4, 0.6, 0.8, 1, 1.2, 1.5},
            .seen_by = spring_experiments(),
            .confused_with = {},
            .advice = "use a compression spring with more travel to solid (k_pe.spring.max_travel_mm)",
            .apply = [](BuiltRig& rig, int side, std::span<const double> values) {
                rig.sides[side].pe_build.binds_at = values[0];
                rig.sides[side].pe_build.binding_rate = values[1];
            }};
}

}  // namespace fusee::effects
