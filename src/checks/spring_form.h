#pragma once
#include "fusee/checks/check.h"

/// Changes of a base spring's wire and coils to what a shop can wind (docs/theory/coils.md, Limits of winding).
namespace fusee::checks {

inline constexpr double kLeastIndex = 4.0, kMostIndex = 20.0;     ///< D/d: EN 15800, EN 13906-3
inline constexpr double kFewestCoils = 2.0;                       ///< active: EN 15800, EN 13906-3
inline constexpr double kThinnest_mm = 0.2, kThickest_mm = 20.0;  ///< wire of the tables of EN 10270-1 that were read

/// Turns or wire for which the coils have the stated rate, and the rate that the stated coils have; each only where it can be wound. If
/// neither turns nor wire can: the nearest coils that have the rate, or that none of this kind have it. @pre wire, coil, coils known
[[nodiscard]] core::Suggestion form_for_rate(const Design& design);

/// The key of the wire's strength, or that no patented wire of this diameter has it. @param strength [Pa]
[[nodiscard]] core::Suggestion stronger_wire(const Design& design, double strength);

}  // namespace fusee::checks
