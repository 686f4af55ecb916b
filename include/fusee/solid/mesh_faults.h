#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "fusee/solid/mesh.h"

/// What is wrong with the triangles of a mesh, and what can be mended: no area, intersections, slivers.
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

/// A quick proof that two triangles of a mesh meet in no point but their common corners: a plane between them, in doubles, with a bound of
/// the rounding. False: not proven, and an exact predicate has to decide. Nearly all neighbours of a part's mesh are proven apart.
[[nodiscard]] bool surely_apart(const Mesh& mesh, const Triangle& f, const Triangle& g);

/// The numbers of all triangles, rising, that have no such proof against another triangle or that have no area: a mesh intersects itself
/// only if these do.
[[nodiscard]] std::vector<std::uint32_t> doubtful_triangles(const Mesh& mesh);
/// The same of a third-party mesh, without the triangles `left_out` (rising); nullopt: more than `most_pairs` pairs of bounding boxes meet.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> doubtful_triangles(const Mesh& mesh, const std::vector<std::uint32_t>& left_out,
                                                                           std::size_t most_pairs);

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
/// @param most limit of pairs of triangles with overlapping boxes @param manifold they are known to be one
[[nodiscard]] Crossings crossings(const Mesh& mesh, const std::vector<std::uint32_t>& flat, std::size_t most = kMostNearPairs,
                                  bool manifold = false);

/// A mesh whose points a kernel has rounded, with its edges under 1e-4 mm collapsed: nearly all folds from rounding are that small.
/// The order of points and triangles is the same in every run and does not depend on the kernel's memory. Empty if the triangles are not a
/// manifold.
[[nodiscard]] std::optional<Mesh> without_slivers(const Mesh& mesh);

/// The same for a mesh that still intersects itself: its edges under `shortest_mm` are collapsed, and triangles without area, which lie
/// along an edge of their neighbour, are removed by edge flips. Also empty where CGAL cannot.
[[nodiscard]] std::optional<Mesh> without_folds(const Mesh& mesh, double shortest_mm);

}  // namespace fusee::solid
