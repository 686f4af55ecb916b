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

void round_to_file(Mesh& mesh) {
    for (Vec3& p : mesh.points_mm)
        for (double& coordinate : p) coordinate = static_cast<double>(static_cast<float>(coordinate));
}

}  // namespace fusee::solid
