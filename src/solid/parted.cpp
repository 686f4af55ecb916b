#include <algorithm>
#include <cmath>
#include <span>

#include "fusee/core/disjoint_sets.h"
#include "fusee/core/units.h"
#include "fusee/solid/mesh_faults.h"

namespace fusee::solid {

namespace {

using core::cross, core::dot, core::minus;

/// One side of a triangle.
struct Side {
    std::uint32_t low, high, triangle;
    bool up;             ///< it runs from low to high
    double angle = 0.0;  ///< of the triangle around the edge [rad]
};

std::vector<Side> sides_by_edge(const Mesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
    });
    return sides;
}

/// Calls `visit` with the sides at each edge.
template <class Visit>
void for_each_edge(std::vector<Side> sides, const Visit& visit) {
    for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
        for (j = i; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high; ++j) {
        }
        visit(std::span(sides).subspan(i, j - i));
    }
}

/// Each edge of more than two triangles gets a point in its middle, so that each pair of them can have a middle of its own: the ends may
/// be one point for all.
void halve_crowded_edges(Mesh& mesh) {
    const std::size_t given = mesh.points_mm.size();
    for (bool again = true; again;) {
        again = false;
        std::vector<bool> halved(mesh.triangles.size(), false);
        for_each_edge(sides_by_edge(mesh), [&](std::span<Side> around) {
            if (around.size() < 3 || around[0].high >= given) return;
            if (std::any_of(around.begin(), around.end(), [&](const Side& s) { return halved[s.triangle]; })) {
                again = true;
                return;
            }
            const auto middle = static_cast<std::uint32_t>(mesh.points_mm.size());
            const Vec3 a = mesh.points_mm[around[0].low], b = mesh.points_mm[around[0].high];
            mesh.points_mm.push_back({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
            for (const Side& side : around) {
                halved[side.triangle] = true;
                Triangle second = mesh.triangles[side.triangle];
                std::replace(second.begin(), second.end(), side.low, middle);
                Triangle& first = mesh.triangles[side.triangle];
                std::replace(first.begin(), first.end(), side.high, middle);
                mesh.triangles.push_back(second);
            }
        });
    }
}

class Parting {
public:
    explicit Parting(const Mesh& mesh) : mesh_(mesh), fans_(3 * mesh.triangles.size()) {}

    Mesh parted() {
        for_each_edge(sides_by_edge(mesh_), [this](std::span<Side> around) { join_all(around); });
        return with_a_point_for_each_fan();
    }

private:
    void join_all(std::span<Side> around) {
        if (around.size() == 2) return join(around[0], around[1]);
        for (Side& side : around) side.angle = angle_of(side);
        std::stable_sort(around.begin(), around.end(), [](const Side& a, const Side& b) { return a.angle < b.angle; });
        // The material of a triangle that runs down the edge is where the angle grows, until the next that runs up.
        for (std::size_t i = 0; i < around.size(); ++i)
            if (const Side& next = around[(i + 1) % around.size()]; !around[i].up && next.up) join(around[i], next);
    }
    [[nodiscard]] double angle_of(const Side& side) const {
        const Vec3 &from = mesh_.points_mm[side.low], axis = minus(mesh_.points_mm[side.high], from);
        const Triangle& t = mesh_.triangles[side.triangle];
        const auto third = *std::find_if(t.begin(), t.end(), [&](std::uint32_t p) { return p != side.low && p != side.high; });
        const Vec3 start = std::abs(axis[0]) <= std::min(std::abs(axis[1]), std::abs(axis[2])) ? Vec3{1, 0, 0}
                           : std::abs(axis[1]) <= std::abs(axis[2])                            ? Vec3{0, 1, 0}
                                                                                               : Vec3{0, 0, 1};
        const Vec3 v = cross(axis, start), u = cross(v, axis), to = minus(mesh_.points_mm[third], from);
        return std::atan2(dot(to, v) * std::sqrt(dot(u, u)), dot(to, u) * std::sqrt(dot(v, v)));
    }
    void join(const Side& a, const Side& b) {
        for (const std::uint32_t point : {a.low, a.high}) fans_.join(corner(a.triangle, point), corner(b.triangle, point));
    }
    [[nodiscard]] std::uint32_t corner(std::uint32_t triangle, std::uint32_t point) const {
        const Triangle& t = mesh_.triangles[triangle];
        return 3 * triangle + (t[0] == point ? 0U : t[1] == point ? 1U : 2U);
    }
    Mesh with_a_point_for_each_fan() {
        constexpr std::uint32_t kNone = ~0U;
        Mesh out;
        std::vector<std::uint32_t> number(3 * mesh_.triangles.size(), kNone);
        for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
            Triangle corners{};
            for (std::uint32_t k = 0; k < 3; ++k) {
                std::uint32_t& known = number[fans_.find(3 * t + k)];
                if (known == kNone) {
                    known = static_cast<std::uint32_t>(out.points_mm.size());
                    out.points_mm.push_back(mesh_.points_mm[mesh_.triangles[t][k]]);
                }
                corners[k] = known;
            }
            out.triangles.push_back(corners);
        }
        return out;
    }

    const Mesh& mesh_;
    core::DisjointSets fans_;  ///< of corners: 3 t + k is the k-th of triangle t
};

}  // namespace

Mesh parted(Mesh mesh) {
    halve_crowded_edges(mesh);
    return Parting(mesh).parted();
}

}  // namespace fusee::solid
