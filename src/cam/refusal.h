#pragma once
#include <vector>

#include "fusee/cam/cam.h"

/// Refusals of a cam, with the nearest change of law or base spring.
namespace fusee::cam {

inline constexpr double kLeastIdleArc = 0.2;  ///< [rad] of normals that a planar contour needs to close

/// "cam.arm", "cam.guide" or "cam.convexity": the first that a contact breaks; none if a cam is possible.
[[nodiscard]] core::Findings check_contacts(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& contacts);

/// "cam.wrap": more groove than a planar cam can have, or more turns than a cam may have.
/// @param travel the cam's angle at the law's highest load [rad]
[[nodiscard]] core::Findings check_wrap(const ArmFunction& arm, const Cam& cam, double travel);

}  // namespace fusee::cam
