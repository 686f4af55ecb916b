#include "slice.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace fusee::report {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // smaller index first
using Ring = std::vector<std::array<double, 2>>;

Edge edge(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

std::array<double, 2> crossing(const solid::Mesh& mesh, const Edge& e, double z) {
    const solid::Vec3 &a = mesh.points_mm[e.first], &b = mesh.points_mm[e.second];
    const double t = (z - a[2]) / (b[2] - a[2]);
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

/// Each cut triangle leads from the edge on which the plane enters it to the edge on which it leaves; the triangles' common sense of
/// rotation makes the pieces follow each other. A vertex in the plane counts as above it, so no edge is cut twice.
std::map<Edge, Edge> pieces(const solid::Mesh& mesh, double z) {
    std::map<Edge, Edge> next;
    for (const solid::Triangle& triangle : mesh.triangles) {
        std::optional<Edge> in, out;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
            const bool above_a = mesh.points_mm[a][2] >= z, above_b = mesh.points_mm[b][2] >= z;
            if (above_a && !above_b) in = edge(a, b);
            if (!above_a && above_b) out = edge(a, b);
        }
        if (in && out) next[*in] = *out;
    }
    return next;
}

}  // namespace

std::vector<Ring> slice(const solid::Mesh& mesh, double z_mm) {
    std::map<Edge, Edge> next = pieces(mesh, z_mm);
    std::vector<Ring> rings;
    while (!next.empty()) {
        Ring ring;
        for (auto at = next.begin(); at != next.end();) {
            ring.push_back(crossing(mesh, at->first, z_mm));
            const Edge to = at->second;
            next.erase(at);
            at = next.find(to);
        }
        rings.push_back(std::move(ring));
    }
    return rings;
}

}  // namespace fusee::report
