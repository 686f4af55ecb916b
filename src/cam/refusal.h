#pragma once
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/core/change.h"

/// Refusals of a cam, with the nearest change of law or base spring.
/// Refusals of a roller cam, with the least change of the roller.
namespace fusee::cam {

inline constexpr double kLeastIdleArc = 0.2;  ///< [rad] of normals that a planar contour needs to close

/// "cam.arm", "cam.guide" or "cam.convexity": the first that a contact breaks; none if a cam is possible.
[[nodiscard]] core::Findings check_contacts(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& contacts);

/// "cam.wrap": more groove than a planar cam can have, or more turns than a cam may have.
/// @param travel the cam's angle at the law's highest load [rad]
[[nodiscard]] core::Findings check_wrap(const ArmFunction& arm, const Cam& cam, double travel);

/// @throws InvalidInput naming the key: a roller on K_SE, a helix, a cable's diameter, or impossible sizes of the follower and its spring
void validate_roller(const ArmFunction& arm, const CamOptions& options);

/// "k_pe.roller.base_radius_mm = ...": the least base radius, on steps of a tenth, with which all contacts are convex and the rim closes;
/// empty if none up to 100 times the given one does.
[[nodiscard]] core::Suggestion wider_base(const ArmFunction& arm, const CamOptions& options);

}  // namespace fusee::cam
