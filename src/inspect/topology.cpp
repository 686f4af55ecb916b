#include "fusee/inspect/topology.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "fusee/core/disjoint_sets.h"
#include "fusee/core/lists.h"
#include "vector.h"

namespace fusee::inspect {

namespace {

struct Edge {
    std::uint32_t low, high, triangle;
    std::uint8_t corner;  ///< at which it begins
    bool up;              ///< it runs from low to high
};

/// By their lower points, then by the higher ones, then by the triangles: counted into place, as most points have three edges that begin
/// there.
std::vector<Edge> edges_of(const solid::Mesh& mesh) {
    std::vector<std::size_t> next(mesh.points_mm.size() + 1, 0);
    const auto for_each_edge = [&mesh](const auto& visit) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (std::uint8_t k = 0; k < 3; ++k) {
                const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
                if (a != b) visit(Edge{std::min(a, b), std::max(a, b), t, k, a < b});
            }
    };
    for_each_edge([&next](const Edge& edge) { ++next[edge.low + 1]; });
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<Edge> edges(next.back());
    for_each_edge([&](const Edge& edge) { edges[next[edge.low]++] = edge; });
    std::size_t begin = 0;
    for (std::size_t point = 0; point + 1 < next.size(); begin = next[point++])
        std::sort(edges.begin() + static_cast<std::ptrdiff_t>(begin), edges.begin() + static_cast<std::ptrdiff_t>(next[point]),
                  [](const Edge& a, const Edge& b) { return a.high != b.high ? a.high < b.high : a.triangle < b.triangle; });
    return edges;
}

/// Corner 3 t + k is the k-th of triangle t; corners at one point that share an edge are one fan.
class Fans {
public:
    explicit Fans(std::size_t triangles) : sets_(3 * triangles) {}
    void join(const solid::Mesh& mesh, const Edge& a, const Edge& b) {
        for (const std::uint32_t point : {a.low, a.high}) sets_.join(corner(mesh, a.triangle, point), corner(mesh, b.triangle, point));
    }
    /// Points with more than one fan, and the triangles there.
    void pinched(const solid::Mesh& mesh, Topology& into) {
        std::vector<std::uint32_t> fan(mesh.points_mm.size(), kNone);
        std::vector<bool> several(mesh.points_mm.size(), false);
        for (std::uint32_t c = 0; c < 3 * mesh.triangles.size(); ++c) {
            const std::uint32_t point = mesh.triangles[c / 3][c % 3], root = sets_.find(c);
            if (fan[point] == kNone) fan[point] = root;
            if (fan[point] != root) several[point] = true;
        }
        into.pinched_points = static_cast<std::size_t>(std::count(several.begin(), several.end(), true));
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            if (std::any_of(mesh.triangles[t].begin(), mesh.triangles[t].end(), [&](std::uint32_t p) { return several[p]; }))
                into.pinched.push_back(t);
    }

private:
    static std::uint32_t corner(const solid::Mesh& mesh, std::uint32_t triangle, std::uint32_t point) {
        const solid::Triangle& t = mesh.triangles[triangle];
        return 3 * triangle + (t[0] == point ? 0u : t[1] == point ? 1u : 2u);
    }
    core::DisjointSets sets_;
};

void number_components(const solid::Mesh& mesh, core::DisjointSets& sets, Topology& topology) {
    std::map<std::uint32_t, std::uint32_t> number;
    std::vector<double> largest;
    topology.component_of.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [found, fresh] = number.try_emplace(sets.find(t), static_cast<std::uint32_t>(topology.components.size()));
        if (fresh) topology.components.emplace_back(), largest.push_back(-1.0);
        topology.component_of[t] = found->second;
        Component& component = topology.components[found->second];
        const solid::Triangle& c = mesh.triangles[t];
        const Vec3 &a = mesh.points_mm[c[0]], &b = mesh.points_mm[c[1]], &d = mesh.points_mm[c[2]];
        component.triangles += 1;
        component.volume_mm3 += dot(a, cross(b, d)) / 6.0;
        const double twice = length(cross(b - a, d - a));
        if (twice > largest[found->second]) largest[found->second] = twice, component.largest = t;
    }
    for (const std::uint32_t t : topology.open) topology.components[topology.component_of[t]].closed = false;
}

}  // namespace

Topology topology_of(const solid::Mesh& mesh) {
    Topology topology;
    topology.neighbour.assign(mesh.triangles.size(), {kNone, kNone, kNone});
    core::DisjointSets sets(mesh.triangles.size());
    Fans fans(mesh.triangles.size());
    const std::vector<Edge> edges = edges_of(mesh);
    for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
        for (j = i; j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high; ++j) {
            sets.join(edges[i].triangle, edges[j].triangle);
            fans.join(mesh, edges[i], edges[j]);
        }
        const auto mark = [&](std::size_t& count, std::vector<std::uint32_t>& triangles) {
            ++count;
            for (std::size_t k = i; k < j; ++k) triangles.push_back(edges[k].triangle);
        };
        if (j == i + 1) mark(topology.open_edges, topology.open);
        if (j > i + 2) mark(topology.crowded_edges, topology.crowded);
        if (j != i + 2) continue;
        if (edges[i].up == edges[i + 1].up) mark(topology.flipped_edges, topology.flipped);
        topology.neighbour[edges[i].triangle][edges[i].corner] = edges[i + 1].triangle;
        topology.neighbour[edges[i + 1].triangle][edges[i + 1].corner] = edges[i].triangle;
    }
    for (auto* list : {&topology.open, &topology.crowded, &topology.flipped}) *list = core::sorted_unique(std::move(*list));
    fans.pinched(mesh, topology);
    number_components(mesh, sets, topology);
    return topology;
}

}  // namespace fusee::inspect
