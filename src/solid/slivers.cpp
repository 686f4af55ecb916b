#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <numeric>

#include "fusee/solid/mesh_faults.h"
#include "surface_mesh.h"

namespace fusee::solid {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

constexpr double kShortest_mm =
    1e-4;  // cures nearly all that rounding exact points leaves; far above a float's last digit at 200 mm, far below any tolerance

/// Would a collapse to `target` turn any triangle around `moved` over?
bool flips(const SurfaceMesh& mesh, SurfaceMesh::Halfedge_index towards_moved, const Kernel::Point_3& target) {
    for (const auto h : CGAL::halfedges_around_target(towards_moved, mesh)) {
        const auto &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.target(mesh.next(h)));
        if (CGAL::squared_distance(a, target) == 0.0 || CGAL::squared_distance(c, target) == 0.0) continue;  // the triangle that vanishes
        if (CGAL::cross_product(b - a, c - a) * CGAL::cross_product(target - a, c - a) < 0.0) return true;
    }
    return false;
}

/// @returns false if there is none, so that the mesh stays as it is
bool collapse_short_edges(SurfaceMesh& mesh, double shortest_mm) {
    std::vector<SurfaceMesh::Edge_index> shorts;
    for (const auto e : mesh.edges())
        if (CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))) < shortest_mm * shortest_mm)
            shorts.push_back(e);
    if (shorts.empty()) return false;
    for (const auto e : shorts) {
        if (mesh.is_removed(e) || !CGAL::Euler::does_satisfy_link_condition(e, mesh)) continue;
        const auto h = mesh.halfedge(e);
        const Kernel::Point_3 keep = mesh.point(mesh.target(h));
        if (flips(mesh, mesh.opposite(h), keep)) continue;
        const auto v = CGAL::Euler::collapse_edge(e, mesh);
        mesh.point(v) = keep;
    }
    mesh.collect_garbage();
    return true;
}

/// Corefinement numbers new vertices and faces by address, so the same solid comes in another order from run to run: points are put in
/// order of their coordinates, triangles in that of their points.
Mesh in_canonical_order(const Mesh& mesh) {
    std::vector<std::uint32_t> order(mesh.points_mm.size()), rank(order.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return mesh.points_mm[a] < mesh.points_mm[b]; });
    Mesh out;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        rank[order[i]] = i;
        out.points_mm.push_back(mesh.points_mm[order[i]]);
    }
    for (const Triangle& t : mesh.triangles) {
        Triangle ranked{rank[t[0]], rank[t[1]], rank[t[2]]};
        std::rotate(ranked.begin(), std::min_element(ranked.begin(), ranked.end()), ranked.end());  // keeps the orientation
        out.triangles.push_back(ranked);
    }
    std::sort(out.triangles.begin(), out.triangles.end());
    return out;
}

}  // namespace

// Which end of a short edge stays depends on the order of edges: it is taken from points in their own order, never from a cut as it comes.
std::optional<Mesh> without_slivers(const Mesh& mesh) {
    Mesh ordered = in_canonical_order(mesh);
    SurfaceMesh surface;
    if (!to_surface_mesh(ordered, surface)) return std::nullopt;
    if (!collapse_short_edges(surface, kShortest_mm)) return ordered;
    return in_canonical_order(from_surface_mesh(surface));
}

std::optional<Mesh> without_folds(const Mesh& mesh, double shortest_mm) {
    SurfaceMesh surface;
    if (!to_surface_mesh(in_canonical_order(mesh), surface)) return std::nullopt;
    (void)collapse_short_edges(surface, shortest_mm);
    if (!pmp::remove_degenerate_faces(surface)) return std::nullopt;
    surface.collect_garbage();
    return in_canonical_order(from_surface_mesh(surface));
}

}  // namespace fusee::solid
