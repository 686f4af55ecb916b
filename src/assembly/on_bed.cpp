#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/assembly/to_make.h"
#include "fusee/checks/support.h"

namespace fusee::assembly {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kWays = 6;     // up to turns about the vertical
constexpr double kBeside_mm = 0.1;   // from a face into what touches it
constexpr double kEqual_mm2 = 50.0;  // of support: then the body lies as low as it can

/// Quarter turns: ways 0 to 2 put z, y and x upright; 3 to 5 the same upside down.
solid::Mesh laid(solid::Mesh mesh, std::size_t way) {
    for (solid::Vec3& p : mesh.points_mm) {
        for (std::size_t i = 0; i < way % 3; ++i) p = {p[2], p[0], p[1]};
        if (way >= 3) p = {p[0], -p[1], -p[2]};
    }
    return mesh;
}

/// Which places lie in a shape.
class Inside {
public:
    explicit Inside(const Extrusion& shape) : to_shape_(shape.frame.inverse()), shape_(shape), ring_(solid::ring_of(shape, kBeside_mm)) {}
    [[nodiscard]] bool holds(const Vector3d& at) const {
        const Vector3d p = to_shape_ * at;
        if (p.z() < 0.0 || p.z() > shape_.length_mm) return false;
        if (shape_.radius_mm > 0.0 && std::hypot(p.x(), p.y()) > shape_.radius_mm) return false;
        return solid::holds(ring_, {p.x(), p.y()});
    }

private:
    Eigen::Isometry3d to_shape_;
    const Extrusion& shape_;
    solid::Ring ring_;
};

/// The mesh without the faces at which its shells touch.
solid::Mesh outside_of(const Body& body, solid::Mesh mesh) {
    const std::vector<Inside> shapes(body.shapes.begin(), body.shapes.end());
    std::erase_if(mesh.triangles, [&](const solid::Triangle& t) {
        const auto corner = [&](std::size_t i) {
            return Vector3d(mesh.points_mm[t[i]][0], mesh.points_mm[t[i]][1], mesh.points_mm[t[i]][2]);
        };
        const Vector3d a = corner(0), b = corner(1), c = corner(2), normal = (b - a).cross(c - a).normalized();
        const Vector3d beside = (a + b + c) / 3.0 + kBeside_mm * normal;
        return std::any_of(shapes.begin(), shapes.end(), [&](const Inside& shape) { return shape.holds(beside); });
    });
    return mesh;
}

}  // namespace

solid::Mesh mesh_on_bed(const Assembly& assembly, const Body& body) {
    const Body& printed = *bodies_to_make(assembly).front();  // the frame's plate lies as they do
    const double overhang = checks::process_limits(process_of(assembly, printed)).overhang;
    solid::Mesh mesh = body.mesh();
    if (overhang <= 0.0) return mesh;
    const solid::Mesh outside = outside_of(body, mesh);
    std::array<double, kWays> areas{}, heights{};
    for (std::size_t way = 0; way < kWays; ++way) {
        const solid::Mesh lying = laid(outside, way);
        const solid::Box box = solid::bounding_box(lying);
        areas[way] = checks::unsupported_mm2(lying, overhang, false);
        heights[way] = box.high_mm[2] - box.low_mm[2];
    }
    const double most = *std::min_element(areas.begin(), areas.end()) + kEqual_mm2;
    std::size_t best = 0;
    for (std::size_t way = 1; way < kWays; ++way)
        if (areas[way] <= most && (areas[best] > most || heights[way] < heights[best] - kBeside_mm)) best = way;
    return laid(std::move(mesh), best);
}

}  // namespace fusee::assembly
