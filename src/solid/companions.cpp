#include "fusee/solid/companions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/outline.h"

namespace fusee::solid {

namespace {

constexpr double kWall_mm = 2.0;      // of a boss: sufficient for every process
constexpr double kLeastWeb_mm = 1.5;  // above a blind bore
constexpr double kSlack_mm = 0.5;     // between turns, beyond the rib

/// " with k_pe.hub.boss_mm = 13"; empty if the part already has it.
std::string at_least(const std::string& key, double has, double needed) {
    return has >= needed ? "" : fmt::format(" with {} = {:g}", key, needed);
}

double boss_mm(const HubOptions& hub) { return std::ceil(2.0 * (bore_reach_mm(hub) + kWall_mm)); }

double pitch_mm(const GrooveOptions& groove, double cable_diameter) {
    const double d = core::mm_from_m(cable_diameter), floor = 2.0 * groove.radius_ratio * d;
    const double width = floor + 2.0 * groove.depth_ratio * d * std::tan(0.5 * std::min(groove.throat, 2.0));
    return std::ceil(10.0 * (width + core::mm_from_m(groove.rib) + kSlack_mm)) / 10.0;
}

}  // namespace

std::string overhung_change(const std::string& part, const HubOptions& hub) {
    const double height = std::ceil(core::mm_from_m(hub.bore_diameter) + std::max(kLeastWeb_mm, core::mm_from_m(hub.web)));
    return fmt::format("{}.hub.kind = \"overhung\"", part) +
           at_least(part + ".hub.boss_mm", core::mm_from_m(hub.boss_diameter), boss_mm(hub)) +
           at_least(part + ".hub.boss_height_mm", core::mm_from_m(hub.boss_height), height);
}

std::string set_screw_change(const std::string& part, const HubOptions& hub) {
    const double screw = std::max(1.0, std::floor(core::mm_from_m(0.5 * hub.bore_diameter)));
    return fmt::format("{}.hub.lock = \"set_screw\"", part) + at_least(part + ".hub.screw_mm", core::mm_from_m(hub.screw_diameter), screw) +
           at_least(part + ".hub.boss_mm", core::mm_from_m(hub.boss_diameter), boss_mm(hub)) +
           at_least(part + ".hub.boss_height_mm", core::mm_from_m(hub.boss_height), screw + 2.0 * kWall_mm);
}

std::string constant_pitch_change(const std::string& part, const GrooveOptions& groove, double cable_diameter) {
    return fmt::format("{0}.path.lead = \"constant_pitch\" with {0}.path.pitch_mm = {1:g}", part, pitch_mm(groove, cable_diameter));
}

std::string helix_change(const std::string& part, const GrooveOptions& groove, double cable_diameter) {
    return fmt::format("{0}.path.kind = \"helix\" with {0}.path.pitch_mm = {1:g}", part, pitch_mm(groove, cable_diameter));
}

}  // namespace fusee::solid
