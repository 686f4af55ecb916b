#include "ray_search.h"

#include <algorithm>
#include <cmath>

namespace fusee::readback {

namespace {

struct Direction {
    double x, y;
};

/// Farthest point along the ray of the horizontal segment pq; -1 for no hit. Closed at both ends: two facets with a common point
/// of the section compute it from the same numbers, so that no ray passes between them.
double hit(Direction u, const std::array<double, 2>& p, const std::array<double, 2>& q) {
    const double cp = u.x * p[1] - u.y * p[0], cq = u.x * q[1] - u.y * q[0];
    const double ap = u.x * p[0] + u.y * p[1], aq = u.x * q[0] + u.y * q[1];
    if (cp == 0.0 && cq == 0.0) return std::max(ap, aq);
    if ((cp > 0.0 && cq > 0.0) || (cp < 0.0 && cq < 0.0)) return -1.0;
    return ap + (aq - ap) * cp / (cp - cq);
}

/// Crossing of edge ab with height z; the lower end first, so that both facets of an edge round in the same way.
std::array<double, 2> crossing(const solid::Vec3& a, const solid::Vec3& b, double z) {
    const solid::Vec3 &low = a[2] <= b[2] ? a : b, &high = a[2] <= b[2] ? b : a;
    const double t = (z - low[2]) / (high[2] - low[2]);
    return {low[0] + (high[0] - low[0]) * t, low[1] + (high[1] - low[1]) * t};
}

double farthest_hit(const std::array<solid::Vec3, 3>& corner, Direction u, double z) {
    std::array<std::array<double, 2>, 6> cut{};  // corners on the plane, then proper crossings
    std::size_t n = 0;
    for (const solid::Vec3& c : corner)
        if (c[2] == z) cut[n++] = {c[0], c[1]};
    for (std::size_t i = 0; i < 3; ++i) {
        const solid::Vec3 &a = corner[i], &b = corner[(i + 1) % 3];
        if ((a[2] < z && b[2] > z) || (a[2] > z && b[2] < z)) cut[n++] = crossing(a, b, z);
    }
    double far = n == 1 ? hit(u, cut[0], cut[0]) : -1.0;
    for (std::size_t i = 0; i + 1 < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) far = std::max(far, hit(u, cut[i], cut[j]));
    return far;
}

}  // namespace

RaySearch::RaySearch(const solid::Mesh& mesh, double low_mm, double high_mm) {
    for (const solid::Triangle& t : mesh.triangles) {
        Facet facet{{mesh.points_mm[t[0]], mesh.points_mm[t[1]], mesh.points_mm[t[2]]}, 0.0, 0.0};
        const auto& c = facet.corner;
        facet.low = std::min({c[0][2], c[1][2], c[2][2]});
        facet.high = std::max({c[0][2], c[1][2], c[2][2]});
        if (facet.high < low_mm || facet.low > high_mm) continue;
        bins_.add(static_cast<std::uint32_t>(facets_.size()),
                  std::array{std::array{c[0][0], c[0][1]}, std::array{c[1][0], c[1][1]}, std::array{c[2][0], c[2][1]}});
        facets_.push_back(facet);
    }
}

std::optional<double> RaySearch::outermost(double azimuth, double z_mm) const {
    const Direction u{std::cos(azimuth), std::sin(azimuth)};
    double far = -1.0;
    for (const std::uint32_t i : bins_.at(azimuth))
        if (const Facet& facet = facets_[i]; facet.low <= z_mm && z_mm <= facet.high)
            far = std::max(far, farthest_hit(facet.corner, u, z_mm));
    return far > 0.0 ? std::optional(far) : std::nullopt;
}

}  // namespace fusee::readback
