#pragma once
#include <string>

#include "fusee/solid/mesh.h"

namespace fusee::report {

/// A mesh for a page: coordinates as 16-bit steps of its box, little-endian, base64.
struct PackedMesh {
    solid::Vec3 low_mm{}, step_mm{};  ///< a coordinate is low + count * step
    std::string points;               ///< base64 of three uint16 a point
    std::string triangles;            ///< base64 of three indices a triangle: uint16, or uint32 with `wide`
    bool wide = false;                ///< more than 65536 points
    /// Largest distance of a packed coordinate from the mesh's: half a step [mm].
    [[nodiscard]] double error_mm() const;
};
[[nodiscard]] PackedMesh packed(const solid::Mesh& mesh);

}  // namespace fusee::report
