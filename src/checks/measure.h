#pragma once
#include <string>

#include "fusee/checks/check.h"
#include "fusee/checks/judge.h"
#include "fusee/core/change.h"

namespace fusee::checks {

bool is_milled(const Design& design);   ///< on three or four axes
bool is_stacked(const Design& design);  ///< from plates cut by wire or laser

inline constexpr double kPaPerMPa = 1e6;

/// The rule for parts of a cable only, in a group that has rules for rollers too.
Rule on_cable(Rule rule);
using core::change, core::number, core::quoted;

/// "k_pe"
std::string name(const Design& design);
/// "k_pe.hub.bore_mm" for "hub.bore_mm"
std::string key_of(const Design& design, const std::string& key);
/// The suggestion of another value for a key of the part: change(design, "hub.bore_mm", down(5.2)).
core::Suggestion change(const Design& design, const std::string& key, std::string value);
/// The anchor hole left out, and the cable's end held outside the part.
core::Suggestion without_anchor_hole(const Design& design);
/// "k_pe at psi 12.0 deg"
std::string where(const Design& design, double psi);
/// @param offset from the cable's centreline along n [m]; -d/2 is the groove's floor
core::Place place(const cam::PathPoint& point, double offset);

}  // namespace fusee::checks
