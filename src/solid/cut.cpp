#include "fusee/solid/cut.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <exception>
#include <numeric>

#include "surface_mesh.h"

namespace fusee::solid {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoints = SurfaceMesh::Property_map<SurfaceMesh::Vertex_index, Exact::Point_3>;

constexpr double kShortest_mm =
    1e-4;  // cures what rounding exact points leaves; far above a float's last digit at 200 mm, far below any tolerance

/// Keeps the exact points beside the rounded ones through consecutive operations (CGAL manual, "Consecutive Boolean operations").
struct ExactMap {
    using value_type = Exact::Point_3;
    using reference = const Exact::Point_3&;
    using key_type = SurfaceMesh::Vertex_index;
    using category = boost::read_write_property_map_tag;

    ExactMap() = default;  // corefinement default-constructs its map type
    explicit ExactMap(SurfaceMesh& mesh) : points(mesh.add_property_map<key_type, Exact::Point_3>("v:exact").first), mesh_(&mesh) {
        for (const auto v : mesh.vertices()) {
            const auto& p = mesh.point(v);
            points[v] = Exact::Point_3(p.x(), p.y(), p.z());
        }
    }
    friend reference get(const ExactMap& map, key_type v) { return map.points[v]; }
    friend void put(const ExactMap& map, key_type v, const Exact::Point_3& p) {
        map.points[v] = p;
        map.mesh_->point(v) = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
    }
    ExactPoints points;
    SurfaceMesh* mesh_ = nullptr;
};

/// A lazy number's double is the middle of the interval known of it, and that interval is as narrow as earlier predicates needed, in an
/// order of addresses: only the exact number's double is the same from run to run.
void round_exact_points(SurfaceMesh& mesh, const ExactMap& map) {
    for (const auto v : mesh.vertices()) {
        const auto& p = map.points[v];
        mesh.point(v) = {CGAL::to_double(p.x().exact()), CGAL::to_double(p.y().exact()), CGAL::to_double(p.z().exact())};
    }
}

/// Would a collapse to `target` turn any triangle around `moved` over?
bool flips(const SurfaceMesh& mesh, SurfaceMesh::Halfedge_index towards_moved, const Kernel::Point_3& target) {
    for (const auto h : CGAL::halfedges_around_target(towards_moved, mesh)) {
        const auto &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)), &c = mesh.point(mesh.target(mesh.next(h)));
        if (CGAL::squared_distance(a, target) == 0.0 || CGAL::squared_distance(c, target) == 0.0) continue;  // the triangle that vanishes
        if (CGAL::cross_product(b - a, c - a) * CGAL::cross_product(target - a, c - a) < 0.0) return true;
    }
    return false;
}

void collapse_short_edges(SurfaceMesh& mesh) {
    std::vector<SurfaceMesh::Edge_index> shorts;
    for (const auto e : mesh.edges())
        if (CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))) < kShortest_mm * kShortest_mm)
            shorts.push_back(e);
    for (const auto e : shorts) {
        if (mesh.is_removed(e) || !CGAL::Euler::does_satisfy_link_condition(e, mesh)) continue;
        const auto h = mesh.halfedge(e);
        const Kernel::Point_3 keep = mesh.point(mesh.target(h));
        if (flips(mesh, mesh.opposite(h), keep)) continue;
        const auto v = CGAL::Euler::collapse_edge(e, mesh);
        mesh.point(v) = keep;
    }
    mesh.collect_garbage();
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

Mesh from_surface_mesh(const SurfaceMesh& mesh) {
    Mesh out;
    for (const auto v : mesh.vertices()) out.points_mm.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
    for (const auto f : mesh.faces()) {
        Triangle t{};
        std::size_t i = 0;
        for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) t[i++] = static_cast<std::uint32_t>(v);
        out.triangles.push_back(t);
    }
    return out;
}

}  // namespace

// Which end of a short edge stays depends on the order of edges: it is taken from points in their own order, never from a cut as it comes.
std::optional<Mesh> without_slivers(const Mesh& mesh) {
    SurfaceMesh surface;
    if (!to_surface_mesh(in_canonical_order(mesh), surface)) return std::nullopt;
    collapse_short_edges(surface);
    return in_canonical_order(from_surface_mesh(surface));
}

std::optional<Mesh> cut(const Mesh& body, const std::vector<Mesh>& tools) try {
    if (tools.empty()) return body;
    SurfaceMesh solid;
    if (!to_surface_mesh(body, solid)) return std::nullopt;
    const ExactMap solid_map(solid);
    for (const Mesh& tool : tools) {
        SurfaceMesh knife;
        if (!to_surface_mesh(tool, knife)) return std::nullopt;
        const ExactMap knife_map(knife);
        if (!pmp::corefine_and_compute_difference(solid, knife, solid, CGAL::parameters::vertex_point_map(solid_map),
                                                  CGAL::parameters::vertex_point_map(knife_map),
                                                  CGAL::parameters::vertex_point_map(solid_map)))
            return std::nullopt;
    }
    solid.collect_garbage();
    round_exact_points(solid, solid_map);
    return without_slivers(from_surface_mesh(solid));
} catch (const std::exception&) {
    return std::nullopt;  // CGAL throws on an input that intersects itself; `validate` says so to the caller
}

}  // namespace fusee::solid
