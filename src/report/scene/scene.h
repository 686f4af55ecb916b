#pragma once
#include <string>

#include "data/json.h"
#include "fusee/assembly/assembly.h"
#include "fusee/report/report.h"
#include "fusee/solid/mesh.h"
#include "page/bundle.h"

/// The pieces of `scene_json`.
namespace fusee::report {

/// The joint of a page's 3D view as JSON (docs/report.md): meshes, bodies, poses, cables, cam tables, curves. @pre design.assembly
[[nodiscard]] std::string scene_json(const DesignReport& design);

/// The drawing along the axis as JSON. @pre design.assembly
[[nodiscard]] std::string joint_plan_json(const DesignReport& design);

/// Gives a page the scene and the drawing along the axis, and its script. @pre design.assembly
void add_scene(Page& page, const DesignReport& design);

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

/// Rounded to 1e-5 of the unit, so that the text is short; NaN is null.
[[nodiscard]] double rounded(double value);
[[nodiscard]] Json vector_json(const Eigen::Vector3d& v);

/// The data of both cams: a row for each working position with angle, arm, tension, radius of curvature, contact and the rules that have a
/// value there; rules without one; the cable from the anchor to the wound end of the working arc.
[[nodiscard]] Json cam_tables_json(const DesignReport& design);

/// Each cable as a line: contact on a cam or end, places that it passes, arc on a drum.
[[nodiscard]] Json cables_json(const assembly::Assembly& assembly);

}  // namespace fusee::report
