#pragma once
#include <optional>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// A mesh whose points a kernel has rounded, with its edges under 1e-4 mm collapsed: nearly all folds from rounding are that small.
/// The order of points and triangles is the same in every run and does not depend on the kernel's memory. Empty if the triangles are not a
/// manifold.
[[nodiscard]] std::optional<Mesh> without_slivers(const Mesh& mesh);

/// The same for a mesh that still intersects itself: its edges under `shortest_mm` are collapsed, and triangles without area, which lie
/// along an edge of their neighbour, are removed by edge flips. Also empty where CGAL cannot.
[[nodiscard]] std::optional<Mesh> without_folds(const Mesh& mesh, double shortest_mm);

}  // namespace fusee::solid
