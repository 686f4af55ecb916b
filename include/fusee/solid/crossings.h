#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// Pairs of triangles whose boxes overlap; each has to be looked at. A surface has about seven for each triangle, a thousand triangles that
/// lie across one another half a million.
inline constexpr std::size_t kMostNearPairs = 50'000'000;

/// Pairs of triangles that pass through each other.
struct Crossings {
    bool manifold = true;  ///< false: the triangles do not form a manifold, of which alone it can be said
    bool complete = true;  ///< false: more than `most` pairs are near each other, so that none was looked at
    std::vector<std::array<std::uint32_t, 2>> pairs = {};  ///< ascending
};

/// Finds them by CGAL's exact predicates. Triangles without area are left out.
/// @param flat the triangles without area, ascending
/// @param most pairs of triangles with overlapping boxes that are looked at
[[nodiscard]] Crossings crossings(const Mesh& mesh, const std::vector<std::uint32_t>& flat, std::size_t most = kMostNearPairs);

}  // namespace fusee::solid
