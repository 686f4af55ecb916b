#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "fusee/core/finding.h"
#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// The conditions for a solid before it is written (CGAL, exact predicates).
struct Validity {
    bool closed = false;   ///< every edge has two triangles, manifold
    bool outward = false;  ///< bounds a volume, normals face outward
    bool self_intersecting = true;
    std::size_t components = 0;
    std::optional<Vec3> meeting_mm;  ///< a corner of a triangle that intersects one that is not its neighbour [mm]
    [[nodiscard]] bool good() const { return closed && outward && !self_intersecting && components == 1; }
    /// "closed, outward, 1 component, no self-intersection" or what is wrong.
    [[nodiscard]] std::string line() const;
};
[[nodiscard]] Validity validate(const Mesh& mesh);

/// Finding "solid.validity". @param solid "the solid" @param part "k_se"
[[nodiscard]] core::Finding invalid_solid(const Validity& validity, const std::string& solid, const std::string& part,
                                          core::Suggestion suggestion);

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
