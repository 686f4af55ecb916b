#pragma once
#include <cstddef>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// Quality figures of a mesh.
struct Quality {
    std::size_t triangles = 0, vertices = 0;
    std::size_t boundary_edges = 0;  ///< 0 for a closed mesh
    int euler = 0;                   ///< V - E + F = 2 - 2 x (through holes)
    double shortest_edge_mm = 0.0;
    double smallest_angle_deg = 0.0;
};
[[nodiscard]] Quality measure_quality(const Mesh& mesh);

}  // namespace fusee::solid
