#pragma once
#include <span>
#include <vector>

#include "fusee/inspect/file.h"

namespace fusee::inspect {

/// The triangles of one body: ascending.
struct Part {
    std::size_t item = 0;
    bool closed = true;
    std::vector<std::uint32_t> triangles;
};

/// Divides a file into its bodies. At an edge of more than two triangles those belong together that have material between them, so that
/// two bodies that touch are two. A closed surface that faces inward is a cavity of the smallest body that contains it.
/// O(triangles log triangles), and a ray for each cavity.
[[nodiscard]] std::vector<Part> divide(const solid::Mesh& mesh, const Topology& topology, std::span<const Item> items, unsigned jobs);

/// These triangles with their own points. @param points of the result: their numbers in `mesh`
[[nodiscard]] solid::Mesh taken(const solid::Mesh& mesh, std::span<const std::uint32_t> triangles, std::vector<std::uint32_t>& points);

}  // namespace fusee::inspect
