#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fusee/core/units.h"
#include "fusee/solid/validity.h"

namespace fusee::solid {

namespace {

using core::dot, core::minus;

/// The sides of all triangles, those between the same two points beside each other.
std::vector<std::pair<std::uint32_t, std::uint32_t>> sides_of(const Mesh& mesh) {
    std::vector<std::size_t> begin(mesh.points_mm.size() + 1, 0);  // of the sides from each point, after counting them
    const auto each_side = [&](const auto& take) {
        for (const Triangle& t : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i) take(std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3]));
    };
    each_side([&](std::uint32_t low, std::uint32_t) { ++begin[low + 1]; });
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides(begin.back());
    std::vector<std::size_t> next = begin;
    each_side([&](std::uint32_t low, std::uint32_t high) { sides[next[low]++] = {low, high}; });
    for (std::size_t i = 0; i + 1 < begin.size(); ++i)
        std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin[i]), sides.begin() + static_cast<std::ptrdiff_t>(begin[i + 1]));
    return sides;
}

/// The cosine of the angle at a, between b and c.
double cosine(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 to_b = minus(b, a), to_c = minus(c, a);
    const double lengths = std::sqrt(dot(to_b, to_b)) * std::sqrt(dot(to_c, to_c));
    return lengths == 0.0 ? 1.0 : std::clamp(dot(to_b, to_c) / lengths, -1.0, 1.0);
}

}  // namespace

Quality measure_quality(const Mesh& mesh) {
    Quality q;
    q.triangles = mesh.triangles.size();
    q.vertices = mesh.points_mm.size();
    const auto sides = sides_of(mesh);
    std::size_t edges = 0;
    double shortest = std::numeric_limits<double>::infinity(), largest_cosine = -1.0;
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end, ++edges) {
        while (end < sides.size() && sides[end] == sides[i]) ++end;
        if (end - i == 1) ++q.boundary_edges;
        const Vec3 along = minus(mesh.points_mm[sides[i].second], mesh.points_mm[sides[i].first]);
        shortest = std::min(shortest, dot(along, along));
    }
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            largest_cosine =
                std::max(largest_cosine, cosine(mesh.points_mm[t[i]], mesh.points_mm[t[(i + 1) % 3]], mesh.points_mm[t[(i + 2) % 3]]));
    q.euler = static_cast<int>(q.vertices) - static_cast<int>(edges) + static_cast<int>(q.triangles);
    q.shortest_edge_mm = std::sqrt(shortest);
    q.smallest_angle_deg = core::deg_from_rad(std::acos(largest_cosine));
    return q;
}

}  // namespace fusee::solid
