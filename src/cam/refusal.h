#pragma once
#include <vector>

#include "fusee/cam/cam.h"

/// What stands in the way of a cam, and the nearest change of law or base spring that clears it.
namespace fusee::cam {

inline constexpr double kLeastIdleArc = 0.2;  ///< [rad] of normals that a planar contour needs to close

/// "cam.arm", "cam.guide" or "cam.convexity": the first that some contact breaks; none if a cam can be made of them.
[[nodiscard]] core::Findings check_contacts(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& contacts);

/// "cam.wrap": more groove than a planar cam has room for, or than anybody winds.
/// @param travel the cam's angle at the law's highest load [rad]
[[nodiscard]] core::Findings check_wrap(const ArmFunction& arm, const Cam& cam, double travel);

}  // namespace fusee::cam
