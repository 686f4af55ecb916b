#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// Pairs of triangles that pass through each other, ascending (CGAL, exact predicates). Nothing: the triangles do not form a manifold, of
/// which alone it can be said. Triangles without area are left out.
/// @param flat the triangles without area, ascending
[[nodiscard]] std::optional<std::vector<std::array<std::uint32_t, 2>>> crossings(const Mesh& mesh, const std::vector<std::uint32_t>& flat);

}  // namespace fusee::solid
