#pragma once
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/inspect/body.h"
#include "vector.h"

namespace fusee::inspect {

inline constexpr double kSamePlane = core::rad_from_deg(0.05);  ///< a turn that single precision may cause

/// Where two triangles with an area meet.
struct Seam {
    std::uint32_t a = 0, b = 0;  ///< a < b
    double turn = 0.0;           ///< angle between their normals [rad]
    bool concave = false;        ///< the space outside the material is inside the bend
    Vec3 along{};                ///< unit
};

/// Calls `visit` with every seam, by a's number.
template <class Visit>
void for_each_seam(const Body& body, const Visit& visit) {
    const auto& points = body.mesh().points_mm;
    for (std::uint32_t a = 0; a < body.mesh().triangles.size(); ++a)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t b = body.topology().neighbour[a][k];
            if (b == kNone || b < a || !(body.areas_mm2()[a] > 0.0) || !(body.areas_mm2()[b] > 0.0)) continue;
            const solid::Triangle& t = body.mesh().triangles[a];
            const Vec3 &from = points[t[k]], &to = points[t[(k + 1) % 3]];
            const Vec3 &n = body.normals()[a], &m = body.normals()[b];
            double farthest = 0.0;  // b's third corner over a's plane: above it the bend is concave
            for (const std::uint32_t p : body.mesh().triangles[b]) {
                const double over = dot(points[p] - from, n);
                if (std::abs(over) > std::abs(farthest)) farthest = over;
            }
            visit(Seam{a, b, std::atan2(length(cross(n, m)), dot(n, m)), farthest > 0.0, unit(to - from)});
        }
}

}  // namespace fusee::inspect
