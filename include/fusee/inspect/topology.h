#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "fusee/solid/mesh.h"
#include "fusee/solid/mesh_faults.h"

namespace fusee::inspect {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Triangles that are connected by their edges.
struct Component {
    std::size_t triangles = 0;
    bool closed = true;       ///< no open edge
    double volume_mm3 = 0.0;  ///< signed: above 0 when the triangles face outward
    std::uint32_t largest = kNone;
};

/// Connections of the triangles of any list. Edges of triangles without area count.
struct Topology {
    std::vector<std::array<std::uint32_t, 3>>
        neighbour;                            ///< across the edge from corner k to the next; kNone unless exactly two meet there
    std::vector<std::uint32_t> component_of;  ///< by triangle
    std::vector<Component> components;        ///< by their first triangle
    std::size_t open_edges = 0;               ///< of one triangle only
    std::size_t crowded_edges = 0;            ///< of more than two
    std::size_t flipped_edges = 0;            ///< of two that run the same way along it
    std::size_t pinched_points = 0;           ///< where surfaces meet in a point only
    std::vector<std::uint32_t> open, crowded, flipped, pinched;  ///< the triangles there, ascending
};
/// O(triangles log triangles). @pre every triangle names points of the mesh
[[nodiscard]] Topology topology_of(const solid::Mesh& mesh);

using solid::flat_triangles;

}  // namespace fusee::inspect
