#pragma once
#include <span>

#include "fusee/cam/arm.h"
#include "fusee/spring/potential.h"

namespace fusee::cam {

/// A cam's arm at one cam angle, as found on a part.
struct FoundArm {
    double angle = 0.0;  ///< cam rotation from the law's lowest load [rad]
    double arm = 0.0;    ///< r, torque over tension [m]; > 0
};

/// The spring at the capstan that follows from a cam's arms and its base spring: the inverse of `ArmFunction` (docs/theory/read_back.md,
/// eq. 1 and 2). Between the rows the arm is their quintic interpolant; torque over the capstan's travel from 0, the law's lowest load, to
/// the last row. Allowance: additions of the rig to each arm, and cable elongation: besides K_SE's travel, behind K_PE's cam.
/// @throws InvalidInput naming "arms[3]" (not above 0) or "angle[3]" (not finite, not ascending), or fewer than 4 rows
[[nodiscard]] spring::PotentialPtr spring_of_arms(PartKind kind, std::span<const FoundArm> arms, const spring::BaseSpring& base,
                                                  double capstan_radius, const Allowance& allowance = {});

}  // namespace fusee::cam
