#pragma once
#include <optional>
#include <vector>

#include "fusee/core/finding.h"
#include "gcode.h"
#include "plates.h"

namespace fusee::toolpath {

/// Drills and reams both holes in each plate (tools 2 and 3), before any outline is cut. Returns the warning "toolpath.dowels" if no
/// two pins fit. @param pitch of the plates along X [mm]
[[nodiscard]] core::Findings bore_dowels(Gcode& code, const solid::Part& part, const Settings& settings, const Cutting& cutting,
                                         const std::vector<Plate>& plates, double pitch);

/// The blind hole for a pin in the blank's upper face by which A is set on the rotary axis.
struct Index {
    solid::Point2 at{};                  ///< body frame [mm]
    double diameter = 0.0, depth = 0.0;  ///< reamed [mm]
};
/// As far from the axis as walls, arbor and features allow; empty: a helix (round blank), no dowel diameter, or no place.
[[nodiscard]] std::optional<Index> index_of(const solid::Part& part, const Settings& settings);
/// Drills and reams it. Returns the warning "toolpath.index" if there is no place.
[[nodiscard]] core::Findings bore_index(Gcode& code, const solid::Part& part, const Settings& settings, const Cutting& cutting);

}  // namespace fusee::toolpath
