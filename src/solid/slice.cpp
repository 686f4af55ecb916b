#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "fusee/core/units.h"
#include "fusee/solid/outline.h"

namespace fusee::solid {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // smaller index first
using Ring = std::vector<std::array<double, 2>>;

constexpr double kStepsPerTurn = 720;

Edge edge(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

std::array<double, 2> crossing(const Mesh& mesh, const Edge& e, double z) {
    const Vec3 &a = mesh.points_mm[e.first], &b = mesh.points_mm[e.second];
    const double t = (z - a[2]) / (b[2] - a[2]);
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

/// Each cut triangle connects the edge where the plane enters it to the edge where it leaves. All triangles have the same orientation, so
/// the pieces form chains. A vertex in the plane counts as above it, so no edge is cut twice.
std::map<Edge, Edge> pieces(const Mesh& mesh, double z) {
    std::map<Edge, Edge> next;
    for (const Triangle& triangle : mesh.triangles) {
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

std::vector<Ring> slice(const Mesh& mesh, double z_mm) {
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

Ring parallel(const cam::Cam& cam, const core::Range& psi, double offset) {
    const int steps = std::max(2, static_cast<int>(std::ceil(psi.width() / core::kTurn * kStepsPerTurn)));
    Ring line;
    for (int i = 0; i <= steps; ++i) {
        const cam::PathPoint p = cam.path(psi.low + psi.width() * i / steps);
        const double c = std::cos(p.psi), s = std::sin(p.psi), h = p.h + offset;
        line.push_back({core::mm_from_m(h * c - p.slope * s), core::mm_from_m(h * s + p.slope * c)});
    }
    return line;
}

}  // namespace fusee::solid
