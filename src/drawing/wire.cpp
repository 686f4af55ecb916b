#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>

#include "fusee/core/units.h"
#include "fusee/drawing/picture.h"

namespace fusee::drawing {

namespace {

using Eigen::Vector3d;

constexpr int kStepsPerTurn = 36;

/// Direction of the line at a point: of the chord between its neighbours.
Vector3d direction_at(const std::vector<Vector3d>& line, std::size_t i) {
    const Vector3d &before = line[i == 0 ? 0 : i - 1], &after = line[i + 1 == line.size() ? i : i + 1];
    return (after - before).normalized();
}

void add_ring(solid::Mesh& mesh, const Vector3d& centre, const Vector3d& across, const Vector3d& up, double radius, int sides) {
    for (int k = 0; k < sides; ++k) {
        const double angle = core::kTurn * k / sides;
        const Vector3d p = centre + radius * (std::cos(angle) * across + std::sin(angle) * up);
        mesh.points_mm.push_back({p.x(), p.y(), p.z()});
    }
}

void add_cap(solid::Mesh& mesh, std::uint32_t first, std::uint32_t sides, bool at_end) {
    for (std::uint32_t k = 1; k + 1 < sides; ++k)
        mesh.triangles.push_back(at_end ? solid::Triangle{first, first + k, first + k + 1}
                                        : solid::Triangle{first, first + k + 1, first + k});
}

}  // namespace

solid::Mesh tube(const std::vector<Vector3d>& line, double radius_mm, int sides) {
    solid::Mesh mesh;
    Vector3d across = direction_at(line, 0).unitOrthogonal();
    const auto n = static_cast<std::uint32_t>(sides);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vector3d along = direction_at(line, i);
        across = (across - across.dot(along) * along).normalized();  // carried along without twist
        add_ring(mesh, line[i], across, along.cross(across), radius_mm, sides);
    }
    for (std::uint32_t i = 0; i + 1 < line.size(); ++i)
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t a = i * n + k, b = i * n + (k + 1) % n;
            mesh.triangles.push_back({a, b, b + n});
            mesh.triangles.push_back({a, b + n, a + n});
        }
    add_cap(mesh, 0, n, false);
    add_cap(mesh, static_cast<std::uint32_t>((line.size() - 1) * n), n, true);
    return mesh;
}

solid::Mesh coil_mesh(const Coil& coil) {
    const int steps = std::max(2, static_cast<int>(std::ceil(coil.turns * kStepsPerTurn)));
    std::vector<Vector3d> line;
    for (int i = 0; i <= steps; ++i) {
        const double share = static_cast<double>(i) / steps, angle = (coil.left_hand ? -1.0 : 1.0) * core::kTurn * coil.turns * share;
        line.emplace_back(coil.mean_radius_mm * std::cos(angle), coil.mean_radius_mm * std::sin(angle),
                          0.5 * coil.wire_mm + share * (coil.length_mm - coil.wire_mm));
    }
    return tube(line, 0.5 * coil.wire_mm);
}

}  // namespace fusee::drawing
