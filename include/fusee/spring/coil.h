#pragma once
#include <optional>

#include "fusee/spring/base_spring.h"

/// What wire and coils of a base spring determine: rate, stress, strength, sizes under load. Formulas: docs/theory/coils.md.
namespace fusee::spring {

/// Are wire and mean coil diameter known?
[[nodiscard]] bool coil_known(const BaseSpring& spring);
/// w = D/d. @pre coil_known
[[nodiscard]] double spring_index(const BaseSpring& spring);

/// Rate that wire, coil, turns and modulus give (eq. 1, 2): torsion E d^4/(64 D n) [Nm/rad], compression G d^4/(8 D^3 n) [N/m].
/// @pre coil_known, active coils known
[[nodiscard]] double rate_of_coils(const BaseSpring& spring);
/// Turns, or wire [m], for which the coils have the rate of `spring`; all else as it is. @pre coil_known; active coils known for the wire
[[nodiscard]] double turns_for_rate(const BaseSpring& spring);
[[nodiscard]] double wire_for_rate(const BaseSpring& spring);

/// Largest stress of the wire under `load` [Nm or N], in Pa, at the inside of the coil (eq. 3, 4): of bending (torsion spring, factor q),
/// of shear (compression spring, Wahl's factor). @pre coil_known
[[nodiscard]] double wire_stress(const BaseSpring& spring, double load);
/// Bending stress of a wire bent to the inner radius `bend_radius` [m] under the moment `moment` [Nm], in Pa (eq. 5). @pre wire known
[[nodiscard]] double bend_stress(const BaseSpring& spring, double moment, double bend_radius);

/// Least tensile strength of patented drawn wire of this class and diameter [m], in Pa: EN 10270-1 (eq. 6); 0 for kUnknown.
[[nodiscard]] double strength_of(WireClass wire_class, double wire_diameter);
/// Strength of the spring's wire [Pa]: as stated, else that of its class; 0: not known.
[[nodiscard]] double tensile_strength(const BaseSpring& spring);
/// Share of that strength which the stress may reach under a rarely changing load: as stated, else 0.7 in bending (EN 13906-3) and
/// 0.8/sqrt 3 in shear; a stated share is divided by sqrt 3 in shear (von Mises).
[[nodiscard]] double allowed_share(const BaseSpring& spring);

/// Compression spring with ground ends: travel until all coils touch [m]; none where free length, coils or wire are not known.
[[nodiscard]] std::optional<double> travel_to_solid(const BaseSpring& spring);
/// Does its load change so often that EN 13906-1 calls it dynamic: from 10 000 cycles on?
[[nodiscard]] bool is_dynamic(const BaseSpring& spring);
/// Compression spring: the travel that must remain between its coils [m]: n (0.0015 D^2/w + 0.1 w) in mm (EN 13906-1), half as much more
/// under a dynamic load, which cold formed springs need. @pre coil_known, active coils known
[[nodiscard]] double least_gaps(const BaseSpring& spring);
/// Inside diameter of the coils [m]; of a torsion spring: wound by `state` [rad] (eq. 7). @pre coil_known, active coils known if torsion
[[nodiscard]] double inside_diameter(const BaseSpring& spring, double state);
/// Length of a torsion spring's close-wound body, wound by `state` [rad], in m (eq. 8). @pre wire and active coils known
[[nodiscard]] double wound_length(const BaseSpring& spring, double state);

/// Angle from a torsion spring's lower leg to its upper one, in the sense in which its coils rise, wound by `state` [rad]: 2 pi n + state.
/// @pre active coils known
[[nodiscard]] double leg_turn(const BaseSpring& spring, double state);

/// Length of the coils' wire [m]: of the active ones, and of a compression spring's two ground ends; legs are not counted.
/// @pre coil_known, active coils known
[[nodiscard]] double wire_length(const BaseSpring& spring);
/// Mass of `length` of its wire, of steel [kg]. @pre wire known
[[nodiscard]] double wire_mass(const BaseSpring& spring, double length);

/// Lowest natural frequency of the coils between two held ends [Hz] (eq. 9): axial (compression), about the axis (torsion).
/// @pre coil_known, active coils known
[[nodiscard]] double surge_frequency(const BaseSpring& spring);

// What follows where it is not stated (0):

/// The active coils from rate, wire and coil diameter, or the rate from the coils: whichever is not stated. Nothing if both are, or if wire
/// or coil diameter is not known (eq. 1, 2).
void derive_coils(BaseSpring& spring);

/// Free length and rating that are not stated, of a spring that must reach `state` [rad or m], its preload included:
/// - free length: of a torsion spring the space for its wound body (eq. 8), with a gap; of a compression spring its solid length and a
///   travel of which `state` takes at most 80 %, leaves the gaps of EN 13906-1, and takes at most 85 % if the rate is 10 % low;
/// - rating, where the strength of the wire is known: the allowed stress (eq. 3, 4), and 85 % of the travel to solid.
/// Nothing follows where wire, coil diameter or active coils are not known. Lengths are rounded up to 0.5 mm.
void derive_length_and_rating(BaseSpring& spring, double state);

/// Space along the axis of a torsion spring wound by `state` [rad], in m: wound_length and a gap, in steps of 0.5 mm.
[[nodiscard]] double axial_space(const BaseSpring& spring, double state);

}  // namespace fusee::spring
