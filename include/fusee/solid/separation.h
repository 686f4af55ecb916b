#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// A quick proof that two triangles of a mesh meet in no point but their common corners: a plane between them, in doubles, with a bound of
/// the rounding. False: not proven, and an exact predicate has to decide. Nearly all neighbours of a part's mesh are proven apart.
[[nodiscard]] bool surely_apart(const Mesh& mesh, const Triangle& f, const Triangle& g);

/// The numbers of all triangles, rising, that have no such proof against another triangle or that have no area: a mesh intersects itself
/// only if these do.
[[nodiscard]] std::vector<std::uint32_t> doubtful_triangles(const Mesh& mesh);
/// The same of a third-party mesh, without the triangles `left_out` (rising); nullopt: more than `most_pairs` pairs of bounding boxes meet.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> doubtful_triangles(const Mesh& mesh, const std::vector<std::uint32_t>& left_out,
                                                                           std::size_t most_pairs);

}  // namespace fusee::solid
