#include "fusee/solid/companions.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/outline.h"

namespace fusee::solid {

namespace {

constexpr double kWall_mm = 2.0;      // of a boss: sufficient for every process
constexpr double kLeastWeb_mm = 1.5;  // above a blind bore
constexpr double kSlack_mm = 0.5;     // between turns, beyond the rib

/// Adds the value that is needed unless the part already has as much.
void add_at_least(core::Suggestion& changes, const std::string& key, double has_mm, double needed_mm) {
    if (has_mm < needed_mm) changes.with(key, core::number(needed_mm));
}
double boss_mm(const HubOptions& hub) { return std::ceil(2.0 * (bore_reach_mm(hub) + kWall_mm)); }

void add_boss(core::Suggestion& changes, const std::string& part, const HubOptions& hub, double height_mm) {
    add_at_least(changes, part + ".hub.boss_mm", core::mm_from_m(hub.boss_diameter), boss_mm(hub));
    add_at_least(changes, part + ".hub.boss_height_mm", core::mm_from_m(hub.boss_height), height_mm);
}

double pitch_mm(const GrooveOptions& groove, double cable_diameter) {
    const double d = core::mm_from_m(cable_diameter), floor = 2.0 * groove.radius_ratio * d;
    const double width = floor + 2.0 * groove.depth_ratio * d * std::tan(0.5 * std::min(groove.throat, 2.0));
    return std::ceil(10.0 * (width + core::mm_from_m(groove.rib) + kSlack_mm)) / 10.0;
}

}  // namespace

core::Suggestion overhung_change(const std::string& part, const HubOptions& hub) {
    const double height = std::ceil(core::mm_from_m(hub.bore_diameter) + std::max(kLeastWeb_mm, core::mm_from_m(hub.web)));
    core::Suggestion changes(part + ".hub.kind", core::quoted("overhung"));
    add_boss(changes, part, hub, height);
    return changes;
}

core::Suggestion set_screw_change(const std::string& part, const HubOptions& hub) {
    const double screw = std::max(1.0, std::floor(core::mm_from_m(0.5 * hub.bore_diameter)));
    core::Suggestion changes(part + ".hub.lock", core::quoted("set_screw"));
    add_at_least(changes, part + ".hub.screw_mm", core::mm_from_m(hub.screw_diameter), screw);
    add_boss(changes, part, hub, screw + 2.0 * kWall_mm);
    return changes;
}

core::Suggestion constant_pitch_change(const std::string& part, const GrooveOptions& groove, double cable_diameter) {
    return core::change(part + ".path.lead", core::quoted("constant_pitch"))
        .with(part + ".path.pitch_mm", core::number(pitch_mm(groove, cable_diameter)));
}

core::Suggestion helix_change(const std::string& part, const GrooveOptions& groove, double cable_diameter) {
    return core::change(part + ".path.kind", core::quoted("helix"))
        .with(part + ".path.pitch_mm", core::number(pitch_mm(groove, cable_diameter)));
}

}  // namespace fusee::solid
