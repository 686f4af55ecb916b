#include <fmt/format.h>

#include "fusee/core/units.h"
#include "measure.h"
#include "needs.h"
#include "shape.h"

namespace fusee::checks {

namespace {

bool is_keyed(const Design& design) {
    const solid::HubOptions& hub = design.part.options.hub;
    return works(design) && hub.lock == solid::HubLock::kKeyway && hub.key_depth * bore_length(design.part) > 0.0;
}

core::Findings measure_shaft_key_pressure(const Design& design, const Allowed& allowed) {
    const solid::HubOptions& hub = design.part.options.hub;
    const double length = bore_length(design.part);
    const auto most = allowed.stated("review", design.cable.max_pressure / kPaPerMPa);
    const double torque = largest_torque(design.part.cam);
    core::Finding f = judge(2.0 * torque / (hub.bore_diameter * hub.key_depth * length) / kPaPerMPa, {*most});
    f.what = fmt::format("pressure of the key on its keyway at {:.3g} Nm", torque);
    f.suggestion = fmt::format("{}.hub.boss_height_mm = {}", name(design),
                               up(core::mm_from_m(hub.boss_height + length * (f.measured / f.allowed - 1.0))));
    return {f};
}

}  // namespace

Rule shaft_key_pressure() {
    return {"shaft.key_pressure",
            "a key that crushes its keyway",
            "keyway: 2 M/(bore t2 length) at the largest torque",
            "the part's material: cable.max_pressure_MPa",
            {review(kAtMost, "MPa", "cable.max_pressure_MPa; not judged without it")},
            measure_shaft_key_pressure,
            false,
            {need::material_pressure("review")},
            is_keyed};
}

}  // namespace fusee::checks
