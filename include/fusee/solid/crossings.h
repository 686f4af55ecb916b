#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// Largest number of pairs of triangles with overlapping boxes; each pair has to be checked. A surface has about seven for each triangle, a
/// thousand triangles across one another have half a million.
inline constexpr std::size_t kMostNearPairs = 50'000'000;

/// Pairs of triangles that intersect.
struct Crossings {
    bool manifold = true;                                  ///< false: the triangles are not a manifold, and nothing was checked
    bool complete = true;                                  ///< false: more than `most` pairs are near each other, and nothing was checked
    std::vector<std::array<std::uint32_t, 2>> pairs = {};  ///< ascending
};

/// Finds them by CGAL's exact predicates. Triangles without area are left out, and those that touch in a corner or an edge of both.
/// @param flat the triangles without area, ascending
/// @param most limit of pairs of triangles with overlapping boxes
[[nodiscard]] Crossings crossings(const Mesh& mesh, const std::vector<std::uint32_t>& flat, std::size_t most = kMostNearPairs);

}  // namespace fusee::solid
