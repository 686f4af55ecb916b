#include "division.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "fusee/core/disjoint_sets.h"
#include "fusee/core/units.h"
#include "vector.h"

namespace fusee::inspect {

namespace {

/// A triangle at an edge of more than two.
struct Leaf {
    std::uint32_t low, high, triangle;
    bool up;  ///< it runs from low to high
    double angle = 0.0;
};

std::vector<Leaf> leaves(const solid::Mesh& mesh, const Topology& topology) {
    std::vector<Leaf> all;
    for (const std::uint32_t t : topology.crowded)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            if (a != b && topology.neighbour[t][k] == kNone) all.push_back({std::min(a, b), std::max(a, b), t, a < b});
        }
    std::sort(all.begin(), all.end(), [](const Leaf& a, const Leaf& b) {
        return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
    });
    return all;
}

constexpr double kSameAngle = 1e-6;  // [rad]: of two faces that lie on each other

/// Joins the triangles of one edge that have material between them: about the edge, upward, material begins behind a triangle that runs
/// down and ends at one that runs up. Where faces lie on each other, one body ends before the next one begins.
/// @returns false if there are not as many beginnings as ends
bool join_about(const solid::Mesh& mesh, std::span<Leaf> edge, core::DisjointSets& sets) {
    const Vec3 &low = mesh.points_mm[edge.front().low], &high = mesh.points_mm[edge.front().high];
    const Frame frame = frame_about(unit(high - low));
    for (Leaf& leaf : edge) {
        const solid::Triangle& t = mesh.triangles[leaf.triangle];
        const std::uint32_t third = t[0] != leaf.low && t[0] != leaf.high ? t[0] : t[1] != leaf.low && t[1] != leaf.high ? t[1] : t[2];
        const Vec3 away = mesh.points_mm[third] - low;
        leaf.angle = std::atan2(dot(away, frame.v), dot(away, frame.u));
    }
    std::stable_sort(edge.begin(), edge.end(), [](const Leaf& a, const Leaf& b) { return a.angle < b.angle; });
    for (std::size_t i = 0, j = 0; i < edge.size(); i = j) {
        for (j = i + 1; j < edge.size() && edge[j].angle - edge[j - 1].angle < kSameAngle; ++j) {
        }
        std::stable_partition(edge.begin() + static_cast<std::ptrdiff_t>(i), edge.begin() + static_cast<std::ptrdiff_t>(j),
                              [](const Leaf& leaf) { return leaf.up; });
    }
    std::deque<std::uint32_t> begun;
    std::size_t joined = 0;
    for (std::size_t i = 0; i < 2 * edge.size(); ++i) {
        const Leaf& leaf = edge[i % edge.size()];
        if (!leaf.up && i < edge.size()) begun.push_back(leaf.triangle);
        if (!leaf.up || begun.empty()) continue;
        sets.join(begun.front(), leaf.triangle);
        begun.pop_front(), ++joined;
    }
    return 2 * joined == edge.size();
}

/// Connected surfaces, by their first triangle.
struct Surface {
    std::vector<std::uint32_t> triangles;
    bool closed = true;
    double volume_mm3 = 0.0, largest_mm2 = -1.0;
    std::uint32_t largest = kNone;
    std::size_t item = 0;
};

std::vector<Surface> surfaces_of(const solid::Mesh& mesh, const Topology& topology, std::span<const Item> items,
                                 std::vector<std::uint32_t>& number) {
    core::DisjointSets sets(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t n : topology.neighbour[t])
            if (n != kNone) sets.join(t, n);
    std::vector<bool> open(mesh.triangles.size(), false);
    for (const std::uint32_t t : topology.open) open[t] = true;
    std::vector<Leaf> all = leaves(mesh, topology);
    for (std::size_t i = 0, j = 0; i < all.size(); i = j) {
        for (j = i; j < all.size() && all[j].low == all[i].low && all[j].high == all[i].high; ++j) {
        }
        if (j - i > 2 && !join_about(mesh, {all.data() + i, j - i}, sets))
            for (std::size_t k = i; k < j; ++k) open[all[k].triangle] = true;
    }
    std::vector<Surface> surfaces;
    number.assign(mesh.triangles.size(), kNone);
    std::size_t item = 0, end = items.front().triangles;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        while (t >= end && item + 1 < items.size()) end += items[++item].triangles;
        const std::uint32_t root = sets.find(t);
        if (number[root] == kNone) number[root] = static_cast<std::uint32_t>(surfaces.size()), surfaces.emplace_back().item = item;
        number[t] = number[root];
        Surface& surface = surfaces[number[t]];
        const solid::Triangle& c = mesh.triangles[t];
        const Vec3 &p = mesh.points_mm[c[0]], &q = mesh.points_mm[c[1]], &r = mesh.points_mm[c[2]];
        surface.triangles.push_back(t);
        surface.volume_mm3 += dot(p, cross(q, r)) / 6.0;
        if (const double area = length(cross(q - p, r - p)); area > surface.largest_mm2) surface.largest_mm2 = area, surface.largest = t;
        if (open[t]) surface.closed = false;
    }
    return surfaces;
}

constexpr std::size_t kMostLooks = kMostVisits / 16;

/// For each surface that faces inward the smallest body of its item that contains it, else kNone.
std::vector<std::uint32_t> containers(const solid::Mesh& mesh, const std::vector<Surface>& surfaces,
                                      const std::vector<std::uint32_t>& number, unsigned jobs) {
    std::vector<std::uint32_t> in(surfaces.size(), kNone);
    const auto inward = [](const Surface& s) { return s.closed && s.volume_mm3 < 0.0; };
    if (surfaces.size() < 2 || std::none_of(surfaces.begin(), surfaces.end(), inward)) return in;
    const Rays rays(mesh, jobs);
    const std::size_t before = Rays::visited();
    for (std::size_t s = 0; s < surfaces.size() && Rays::visited() - before < kMostLooks; ++s) {
        if (!inward(surfaces[s])) continue;
        const auto corner = [&](std::uint32_t t, std::size_t k) -> const Vec3& { return mesh.points_mm[mesh.triangles[t][k]]; };
        const std::uint32_t largest = surfaces[s].largest;
        const Vec3 from = (1.0 / 3.0) * (corner(largest, 0) + corner(largest, 1) + corner(largest, 2));
        std::map<std::uint32_t, int> around;
        for (const std::uint32_t t : rays.all(from, kAskew))
            around[number[t]] += dot(cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)), kAskew) > 0.0 ? 1 : -1;
        for (const auto& [other, net] : around)
            if (net > 0 && other != s && surfaces[other].closed && surfaces[other].volume_mm3 > 0.0 &&
                surfaces[other].item == surfaces[s].item && (in[s] == kNone || surfaces[other].volume_mm3 < surfaces[in[s]].volume_mm3))
                in[s] = other;
    }
    return in;
}

}  // namespace

std::vector<Part> divide(const solid::Mesh& mesh, const Topology& topology, std::span<const Item> items, unsigned jobs) {
    std::vector<std::uint32_t> number;
    std::vector<Surface> surfaces = surfaces_of(mesh, topology, items, number);
    const std::vector<std::uint32_t> in = containers(mesh, surfaces, number, jobs);
    std::vector<std::uint32_t> part_of(surfaces.size(), kNone);
    std::vector<Part> parts;
    std::map<std::size_t, std::uint32_t> open_part;  // by item
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        if (in[s] != kNone) continue;
        part_of[s] = static_cast<std::uint32_t>(parts.size());
        if (!surfaces[s].closed) part_of[s] = open_part.try_emplace(surfaces[s].item, part_of[s]).first->second;
        if (part_of[s] == parts.size()) parts.push_back({surfaces[s].item, surfaces[s].closed, {}});
    }
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        std::vector<std::uint32_t>& to = parts[part_of[in[s] == kNone ? s : in[s]]].triangles;
        to.insert(to.end(), surfaces[s].triangles.begin(), surfaces[s].triangles.end());
        surfaces[s].triangles = {};
    }
    for (Part& part : parts) std::sort(part.triangles.begin(), part.triangles.end());
    return parts;
}

solid::Mesh taken(const solid::Mesh& mesh, std::span<const std::uint32_t> triangles, std::vector<std::uint32_t>& points) {
    for (const std::uint32_t t : triangles) points.insert(points.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    solid::Mesh own;
    own.triangles.reserve(triangles.size());
    for (const std::uint32_t p : points) own.points_mm.push_back(mesh.points_mm[p]);
    const auto place = [&points](std::uint32_t p) {
        return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
    };
    for (const std::uint32_t t : triangles) {
        const solid::Triangle& c = mesh.triangles[t];
        own.triangles.push_back({place(c[0]), place(c[1]), place(c[2])});
    }
    return own;
}

}  // namespace fusee::inspect
