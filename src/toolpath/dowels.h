#pragma once
#include <vector>

#include "fusee/core/finding.h"
#include "gcode.h"
#include "plates.h"

namespace fusee::toolpath {

/// Two places for dowel pins, in the part's body frame: each keeps a wall from groove floor, bore, key, slot and anchor hole, and they are
/// as far apart as possible. Empty if there are none.
[[nodiscard]] std::vector<solid::Point2> dowel_places(const solid::Part& part, const Settings& settings,
                                                      const std::vector<solid::Arc>& floor);

/// Drills and reams both holes in each plate (tools 2 and 3), before any outline is cut. Returns the warning "toolpath.dowels" if no
/// two pins fit. @param pitch of the plates along X [mm]
[[nodiscard]] core::Findings bore_dowels(Gcode& code, const solid::Part& part, const Settings& settings, const std::vector<Plate>& plates,
                                         double pitch);

}  // namespace fusee::toolpath
