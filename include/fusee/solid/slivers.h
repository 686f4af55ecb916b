#pragma once
#include <optional>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// A mesh whose points a kernel rounded, with its edges under 1e-4 mm collapsed: nearly all that rounding folds over is that small.
/// Points and triangles come back in an order that is the same from run to run, wherever the kernel's memory lay. Empty if the triangles
/// form no manifold.
[[nodiscard]] std::optional<Mesh> without_slivers(const Mesh& mesh);

/// The same for a mesh that still meets itself: with its edges under `shortest_mm` collapsed, and triangles without an area, which lie
/// along an edge of their neighbour, flipped away. Empty also where CGAL cannot.
[[nodiscard]] std::optional<Mesh> without_folds(const Mesh& mesh, double shortest_mm);

}  // namespace fusee::solid
