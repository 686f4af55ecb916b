#pragma once
#include "fusee/spring/base_spring.h"

/// What follows from wire and coils of a base spring where it is not stated (0). Formulas: docs/theory/coils.md.
namespace fusee::spring {

/// The active coils from rate, wire and coil diameter, or the rate from the coils: whichever is not stated. Nothing if both are, or if wire
/// or coil diameter is not known (eq. 1, 2).
void derive_coils(BaseSpring& spring);

/// Free length and rating that are not stated, of a spring that must reach `state` [rad or m], its preload included:
/// - free length: of a torsion spring the space for its wound body (eq. 8), with a gap; of a compression spring its solid length and a
///   travel of which `state` takes at most 80 %, leaves the gaps of EN 13906-1, and takes at most 85 % if the rate is 10 % low;
/// - rating, where the strength of the wire is known: the allowed stress (eq. 3, 4), and 85 % of the travel to solid.
/// Nothing where wire, coil diameter or active coils are not known. Lengths are rounded up to 0.5 mm.
void derive_length_and_rating(BaseSpring& spring, double state);

/// Space along the axis of a torsion spring wound by `state` [rad], in m: wound_length and a gap, in steps of 0.5 mm.
[[nodiscard]] double axial_space(const BaseSpring& spring, double state);

}  // namespace fusee::spring
