#pragma once
#include <optional>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// Body minus every tool, by CGAL's corefinement on exact points (plain doubles fail on helical grooves), with the edges that rounding back
/// to doubles leaves under 1e-4 mm collapsed, in an order that is the same from run to run. Empty at the first cut that CGAL refuses:
/// nothing is carried on from a failed Boolean.
/// @pre body and tools are closed, oriented and free of self-intersections
[[nodiscard]] std::optional<Mesh> cut(const Mesh& body, const std::vector<Mesh>& tools);

/// A mesh that another kernel made and rounded, with its edges under 1e-4 mm collapsed: what rounding folds over is that small. Comes back
/// in the order of `cut`; empty if the triangles form no manifold.
[[nodiscard]] std::optional<Mesh> without_slivers(const Mesh& mesh);

}  // namespace fusee::solid
