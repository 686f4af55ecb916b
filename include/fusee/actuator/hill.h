#pragma once
#include "fusee/spring/potential.h"

namespace fusee::actuator {

/// Figure 2, two arrangements of Hill's muscle, as the paper uses them (docs/theory/hill.md):
/// "series": K_SE in series with (contractile element parallel to K_PE): F = F_SE(L - l) = F_PE(l) + f. The actuator's own arrangement.
/// "parallel": K_PE parallel to (contractile element in series with K_SE): F = F_PE(L) + f, f = F_SE(L - x).
/// L is the stretch of the whole muscle, l and x that of the contractile element, f its active force. With linear springs the two are
/// equivalent by the map below (McMahon, Muscles, Reflexes, and Locomotion, 1984, p. 23): equal force at every L, equal work of the
/// contractile element. Every function: @throws InvalidInput naming the stiffness unless k_se > 0 and k_pe >= 0
struct LinearMuscle {
    double k_se = 0.0;  ///< [N/m] or [Nm/rad], > 0
    double k_pe = 0.0;  ///< >= 0
};
/// Force of the series arrangement at stretch L under active force f.
[[nodiscard]] double series_force(const LinearMuscle& muscle, double length, double active);
/// Stretch l of its contractile element in that state.
[[nodiscard]] double series_contractile(const LinearMuscle& muscle, double length, double active);
/// Force of the parallel arrangement at stretch L with contractile stretch x.
[[nodiscard]] double parallel_force(const LinearMuscle& muscle, double length, double contractile);
/// The parallel arrangement that is equivalent to a series one.
[[nodiscard]] LinearMuscle parallel_from_series(const LinearMuscle& muscle);
/// The series arrangement that is equivalent to a parallel one.
[[nodiscard]] LinearMuscle series_from_parallel(const LinearMuscle& muscle);
/// Stretch x of the parallel arrangement's contractile element for active force f of the series one at stretch L.
[[nodiscard]] double contractile_from_active(const LinearMuscle& series, double length, double active);

/// Nonlinear springs: the passive tension of the series arrangement is that of both springs in series, with equal forces: the K_PE of the
/// parallel arrangement, a potential over L. Its domain begins where both springs are off their stops and ends at the first spring's end.
/// @throws InvalidInput naming the spring if one is missing or not stiff (U'' > 0) throughout, or if no force is common to both
[[nodiscard]] spring::PotentialPtr passive_tension(spring::PotentialPtr k_se, spring::PotentialPtr k_pe);

}  // namespace fusee::actuator
