#pragma once
#include <optional>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// Body minus every tool, by CGAL's corefinement on exact points (plain doubles fail on helical grooves), without the slivers that rounding
/// back to doubles leaves (slivers.h). Empty at the first cut that CGAL refuses: nothing is carried on from a failed Boolean.
/// @pre body and tools are closed, oriented and free of self-intersections
[[nodiscard]] std::optional<Mesh> cut(const Mesh& body, const std::vector<Mesh>& tools);

}  // namespace fusee::solid
