#pragma once
#include "fusee/checks/check.h"

/// Changes of a base spring's wire and coils to what a shop can wind (docs/theory/coils.md, Limits of winding).
/// The nearest feasible base spring, as keys of the profile. Every change keeps the law: the energy that the spring stores stays the same.
namespace fusee::checks {

inline constexpr double kLeastIndex = 4.0, kMostIndex = 20.0;     ///< D/d: EN 15800, EN 13906-3
inline constexpr double kFewestCoils = 2.0;                       ///< active: EN 15800, EN 13906-3
inline constexpr double kThinnest_mm = 0.2, kThickest_mm = 20.0;  ///< wire of the tables of EN 10270-1 that were read

/// Turns or wire for which the coils have the stated rate, and the rate that the stated coils have; each only where it can be wound. If
/// neither turns nor wire can: the nearest coils that have the rate, or that none of this kind have it. @pre wire, coil, coils known
[[nodiscard]] core::Suggestion form_for_rate(const Design& design);

/// The key of the wire's strength, or that no patented wire of this diameter has it. @param strength [Pa]
[[nodiscard]] core::Suggestion stronger_wire(const Design& design, double strength);

/// Largest deflection of the base spring over the working range, preload included [rad or m].
double largest_state(const Design& design);

/// Least deflection of the base spring over the working range [rad or m]: its preload if nothing works.
double least_state(const Design& design);
/// Inner radius of the bend between coil and axial leg [m]: as stated, else the wire's diameter.
double leg_bend_radius(const spring::BaseSpring& spring);
/// Force of the leg on the middle of its slot at the largest torque [N]. @pre the part has a slot
double leg_force(const Design& design);

/// Rate and preload that scale every arm by `factor`. K_SE: r = sqrt((k_t phi0)^2 + 2 k_t U)/U', so k_t f^2 and phi0/f;
/// K_PE: r = U'/sqrt((k y0)^2 + 2 k U), so k/f^2 and y0 f.
core::Suggestion scale_arms(const Design& design, double factor);

/// A preload, or a rate, or both in the proportion of `scale_arms`, for a largest state of `state` [rad or m].
core::Suggestion limit_state(const Design& design, double state);

/// A preload, or a rate, for a largest load of `load` [Nm or N].
core::Suggestion limit_load(const Design& design, double load);

}  // namespace fusee::checks
