#pragma once
#include <cstdint>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// Triangles without area: corners that are one point or lie in a line (height below 1e-9 of the longest edge). Ascending.
[[nodiscard]] std::vector<std::uint32_t> flat_triangles(const Mesh& mesh);

/// The mesh with as few of them as can be, on the same surface: one between a long edge and a point on it is flipped with its neighbour
/// across that edge, one with two corners at one place is collapsed. Neither changes how the surface is connected. Triangles at edges of
/// more or fewer than two stay.
[[nodiscard]] Mesh without_flat_triangles(Mesh mesh);

/// The mesh with a point for each fan of triangles: where a surface touches itself in a point or an edge, it is taken apart there and
/// touches without being connected. Of four triangles at an edge, those are connected that have the same material between them.
[[nodiscard]] Mesh parted(Mesh mesh);

}  // namespace fusee::solid
