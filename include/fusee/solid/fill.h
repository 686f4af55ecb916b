#pragma once
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

using VertexRing = std::vector<std::uint32_t>;  ///< vertex numbers of a mesh, counter-clockwise seen from above

/// Fills a horizontal face between an outer ring and holes with a constrained Delaunay triangulation over the rings' own vertices (none
/// added).
/// @param up true: the face faces up (+z); false: down
/// @pre the holes lie inside the outer ring
/// @returns false where a ring crosses itself or another: then nothing is added
bool fill_face(Mesh& mesh, const VertexRing& outer, const std::vector<VertexRing>& holes, bool up);

/// Adds a ring's vertices at height z and returns their numbers.
VertexRing add_ring(Mesh& mesh, const std::vector<std::array<double, 2>>& ring, double z_mm);

/// The vertical wall between two rings of equal length, one above the other. @param outward true: solid inside the ring
void add_wall_between(Mesh& mesh, const VertexRing& lower, const VertexRing& upper, bool outward);

/// A convex ring as a prism from z_low to z_high.
[[nodiscard]] Mesh prism(const std::vector<std::array<double, 2>>& ring, double z_low_mm, double z_high_mm);

}  // namespace fusee::solid
