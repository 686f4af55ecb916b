#include "fusee/solid/mesh.h"

#include <algorithm>
#include <limits>

namespace fusee::solid {

Box bounding_box(const Mesh& mesh) {
    constexpr double kFar = std::numeric_limits<double>::max();
    Box box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    for (const Vec3& p : mesh.points_mm)
        for (std::size_t i = 0; i < 3; ++i) {
            box.low_mm[i] = std::min(box.low_mm[i], p[i]);
            box.high_mm[i] = std::max(box.high_mm[i], p[i]);
        }
    return box;
}

double volume_mm3(const Mesh& mesh) {
    double six = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.points_mm[t[0]], &b = mesh.points_mm[t[1]], &c = mesh.points_mm[t[2]];
        six += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return six / 6.0;
}

bool is_closed_and_oriented(std::span<const Triangle> triangles) {
    std::vector<std::uint64_t> up, down;  // edges as (lower corner, higher corner), by the direction of their triangle
    up.reserve(3 * triangles.size() / 2);
    down.reserve(up.capacity());
    for (const Triangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint64_t from = t[i], to = t[(i + 1) % 3];
            if (from == to) return false;
            (from < to ? up : down).push_back(std::min(from, to) << 32U | std::max(from, to));
        }
    std::sort(up.begin(), up.end());
    std::sort(down.begin(), down.end());
    return up == down && std::adjacent_find(up.begin(), up.end()) == up.end();
}

void round_to_file(Mesh& mesh) {
    for (Vec3& p : mesh.points_mm)
        for (double& coordinate : p) coordinate = static_cast<double>(static_cast<float>(coordinate));
}

}  // namespace fusee::solid
