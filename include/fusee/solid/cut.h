#pragma once
#include <optional>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// Body minus every tool, by CGAL's corefinement on exact points (plain doubles fail on helical grooves) of the triangles near each tool,
/// or of the whole body where these do not decide. Slivers from rounding back to doubles are removed (slivers.h). Empty at the first cut
/// that CGAL refuses: the result of a failed Boolean is never used.
/// @pre body and tools are closed, oriented and free of self-intersections
[[nodiscard]] std::optional<Mesh> cut(const Mesh& body, const std::vector<Mesh>& tools);

}  // namespace fusee::solid
