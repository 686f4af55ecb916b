#pragma once
#include <optional>

#include "fusee/inspect/body.h"

namespace fusee::inspect {

/// Follows the material between two faces from a ball that touches both, to where they come nearer: do they meet in an edge, or does the
/// wall end in a face or a rounding, stay parallel or become thicker again? The faces may be curved.
/// @param width_mm diameter of the ball @param one, other unit vectors from its middle to its contacts
[[nodiscard]] std::optional<SharpEdge> edge_ahead(const Body& body, solid::Vec3 middle_mm, solid::Vec3 one, solid::Vec3 other,
                                                  double width_mm);

}  // namespace fusee::inspect
