#include "fusee/solid/mesh.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "fusee/cam/mirror.h"
#include "fusee/core/units.h"
#include "fusee/solid/part.h"

namespace fusee::solid {

namespace {

/// The columns keep their places and are numbered from the start of the mirrored groove.
std::vector<double> mirrored(const std::vector<double>& columns_psi, double groove_begin) {
    constexpr double kSame = 1e-6;  // [rad]: the column at the start of the groove may be rounded to before it
    std::vector<double> columns;
    columns.reserve(columns_psi.size());
    for (const double psi : columns_psi) columns.push_back(core::within_turn(-psi, groove_begin - kSame));
    std::sort(columns.begin(), columns.end());
    return columns;
}

}  // namespace

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

Mesh mirrored(const Mesh& mesh) {
    Mesh other = mesh;
    for (Vec3& p : other.points_mm) p[1] = -p[1];
    for (Triangle& t : other.triangles) std::swap(t[1], t[2]);
    return other;
}

PartOptions mirrored(const PartOptions& options) {
    PartOptions other = options;
    other.features.leg_slot_angle = -options.features.leg_slot_angle;
    return other;
}

Part mirrored(const Part& part) {
    Part other = part;
    other.cam = cam::mirrored(part.cam);
    other.options = mirrored(part.options);
    other.mesh = mirrored(part.mesh);
    other.skin = mirrored(part.skin);
    other.columns_psi = mirrored(part.columns_psi, other.cam.groove_psi.low);
    return other;
}

}  // namespace fusee::solid
