#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

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

}  // namespace fusee::solid
