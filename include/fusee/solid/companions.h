#pragma once
#include <string>

#include "fusee/cam/cam.h"
#include "fusee/core/change.h"
#include "fusee/solid/part.h"

/// Changes of a profile that need several keys together. One key alone would be refused.
namespace fusee::solid {

/// "k_pe.hub.kind = "overhung" with k_pe.hub.boss_mm = 13 with k_pe.hub.boss_height_mm = 8": a boss with 2 mm of wall around bore and key,
/// as high as the bore is wide, above the web. Values that the hub already has are omitted.
[[nodiscard]] core::Suggestion overhung_change(const std::string& part, const HubOptions& hub);

/// "k_se.hub.lock = "set_screw" with ...": a screw of half the shaft's diameter, and a boss for it.
[[nodiscard]] core::Suggestion set_screw_change(const std::string& part, const HubOptions& hub);

/// "k_pe.path.lead = "constant_pitch" with k_pe.path.pitch_mm = 5.3": grooves of that depth and throat with their rib between them.
[[nodiscard]] core::Suggestion constant_pitch_change(const std::string& part, const GrooveOptions& groove, double cable_diameter);
/// The same from a planar path: "k_pe.path.kind = "helix" with ...".
[[nodiscard]] core::Suggestion helix_change(const std::string& part, const GrooveOptions& groove, double cable_diameter);

}  // namespace fusee::solid
