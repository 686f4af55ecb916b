#pragma once
#include "fusee/cam/cam.h"
#include "fusee/core/change.h"

/// Refusals of a roller cam, with the least change of the roller.
namespace fusee::cam {

/// @throws InvalidInput naming the key: a roller on K_SE, a helix, a cable's diameter, or impossible sizes of the follower and its spring
void validate_roller(const ArmFunction& arm, const CamOptions& options);

/// "k_pe.roller.base_radius_mm = ...": the least base radius, on steps of a tenth, with which all contacts are convex and the rim closes;
/// empty if none up to 100 times the given one does.
[[nodiscard]] core::Suggestion wider_base(const ArmFunction& arm, const CamOptions& options);

}  // namespace fusee::cam
