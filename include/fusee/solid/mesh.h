#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// Triangle meshes, and how their faces are filled.
namespace fusee::solid {

using Vec3 = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

/// A closed triangle mesh in the part's body frame, millimetres; triangles are counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vec3> points_mm;
    std::vector<Triangle> triangles;
};

struct Box {
    Vec3 low_mm{}, high_mm{};
};
[[nodiscard]] Box bounding_box(const Mesh& mesh);
/// Signed volume [mm^3]: above 0 when the triangles face outward.
[[nodiscard]] double volume_mm3(const Mesh& mesh);
/// Has every edge exactly two triangles, which run along it in opposite directions? Corners of a triangle must differ. O(n log n)
[[nodiscard]] bool is_closed_and_oriented(std::span<const Triangle> triangles);
/// STL has single precision. A mesh is rounded to it before its proof of validity, so that the proof holds for the file.
void round_to_file(Mesh& mesh);

using VertexRing = std::vector<std::uint32_t>;  ///< vertex numbers of a mesh, counter-clockwise seen from above

/// Fills a horizontal face between an outer ring and holes with a constrained Delaunay triangulation over the rings' own vertices (none
/// added).
/// @param up true: the face faces up (+z); false: down
/// @pre the holes lie inside the outer ring
/// @returns false where a ring crosses itself or another: then nothing is added
bool fill_face(Mesh& mesh, const VertexRing& outer, const std::vector<VertexRing>& holes, bool up);

/// Adds a ring's vertices at height z and returns their numbers.
VertexRing add_ring(Mesh& mesh, const std::vector<std::array<double, 2>>& ring, double z_mm);

/// The vertical wall between two rings of equal length, one above the other. @param outward true: solid inside the ring
void add_wall_between(Mesh& mesh, const VertexRing& lower, const VertexRing& upper, bool outward);

/// A convex ring as a prism from z_low to z_high.
[[nodiscard]] Mesh prism(const std::vector<std::array<double, 2>>& ring, double z_low_mm, double z_high_mm);

}  // namespace fusee::solid
