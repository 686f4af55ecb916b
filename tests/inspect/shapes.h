#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "fusee/inspect/rule.h"
#include "fusee/solid/mesh.h"

/// Solids made by hand, whose every measure is known [mm].
namespace fusee::inspect {

using Ring = std::vector<std::array<double, 2>>;
inline constexpr double kPi = 3.141592653589793;

inline Ring rectangle(double width, double depth, double x = 0.0, double y = 0.0) {
    const double w = 0.5 * width, d = 0.5 * depth;
    return {{x - w, y - d}, {x + w, y - d}, {x + w, y + d}, {x - w, y + d}};
}
/// Corners on a circle.
inline Ring polygon(double diameter, int sides) {
    Ring ring;
    for (int i = 0; i < sides; ++i) {
        const double a = 2.0 * kPi * i / sides;
        ring.push_back({0.5 * diameter * std::cos(a), 0.5 * diameter * std::sin(a)});
    }
    return ring;
}
/// A rectangle whose corners are arcs of eight facets.
inline Ring rounded(double width, double depth, double radius) {
    Ring ring;
    for (int corner = 0; corner < 4; ++corner) {
        const double cx = (corner == 0 || corner == 3 ? 1 : -1) * (0.5 * width - radius),
                     cy = (corner < 2 ? 1 : -1) * (0.5 * depth - radius);
        for (int i = 0; i <= 8; ++i) {
            const double a = 0.5 * kPi * (corner + i / 8.0);
            ring.push_back({cx + radius * std::cos(a), cy + radius * std::sin(a)});
        }
    }
    return ring;
}

struct Storey {
    Ring ring;
    double top;
};
/// Storeys one on the other from z = 0 up; of two neighbours one ring holds the other.
inline solid::Mesh tower(const std::vector<Storey>& storeys) {
    solid::Mesh mesh;
    solid::VertexRing below = add_ring(mesh, storeys.front().ring, 0.0);
    fill_face(mesh, below, {}, false);
    for (std::size_t i = 0; i < storeys.size(); ++i) {
        const solid::VertexRing above = add_ring(mesh, storeys[i].ring, storeys[i].top);
        add_wall_between(mesh, below, above, true);
        if (i + 1 == storeys.size()) {
            fill_face(mesh, above, {}, true);
            break;
        }
        const auto reach = [](const Ring& r) { return std::max_element(r.begin(), r.end())->front(); };
        below = add_ring(mesh, storeys[i + 1].ring, storeys[i].top);
        const bool narrows = reach(storeys[i + 1].ring) < reach(storeys[i].ring);
        if (narrows)
            fill_face(mesh, above, {below}, true);
        else
            fill_face(mesh, below, {above}, false);
    }
    return mesh;
}
inline solid::Mesh block(double width, double depth, double height) { return tower({{rectangle(width, depth), height}}); }

/// A block with a hole from its top down to `floor`; through where `floor` is NaN.
inline solid::Mesh sunk(const Ring& outer, const Ring& hole, double height, double floor = NAN) {
    solid::Mesh mesh;
    const bool through = std::isnan(floor);
    const solid::VertexRing low = add_ring(mesh, outer, 0.0), high = add_ring(mesh, outer, height);
    const solid::VertexRing hole_low = add_ring(mesh, hole, through ? 0.0 : floor), hole_high = add_ring(mesh, hole, height);
    add_wall_between(mesh, low, high, true);
    add_wall_between(mesh, hole_low, hole_high, false);
    fill_face(mesh, high, {hole_high}, true);
    if (through)
        fill_face(mesh, low, {hole_low}, false);
    else
        fill_face(mesh, low, {}, false), fill_face(mesh, hole_low, {}, true);
    return mesh;
}

inline void add(solid::Mesh& to, const solid::Mesh& more, const solid::Vec3& by = {}) {
    const auto first = static_cast<std::uint32_t>(to.points_mm.size());
    for (const solid::Vec3& p : more.points_mm) to.points_mm.push_back({p[0] + by[0], p[1] + by[1], p[2] + by[2]});
    for (const solid::Triangle& t : more.triangles) to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}
inline solid::Mesh reversed(solid::Mesh mesh) {
    for (solid::Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

/// Corners at one place become one, as when a reader joins them.
inline solid::Mesh welded(solid::Mesh mesh) {
    std::map<solid::Vec3, std::uint32_t> first;
    for (solid::Triangle& t : mesh.triangles)
        for (std::uint32_t& p : t) p = first.try_emplace(mesh.points_mm[p], p).first->second;
    return mesh;
}

inline core::Findings findings_of(const solid::Mesh& mesh, checks::ProcessKind kind) {
    checks::Process process;
    process.kind = kind;
    const File file(mesh, {}, 20'000, 1);  // 4,000 for one body
    core::Findings findings;
    for (const Marked& m : check({file.pieces().front().body, process, {}, &file}, "file")) findings.push_back(m.finding);
    for (const Piece& piece : file.pieces())
        for (const Marked& m : check({piece.body, process}, piece.name.empty() ? "part" : piece.name)) findings.push_back(m.finding);
    return findings;
}

}  // namespace fusee::inspect
