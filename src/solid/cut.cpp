#include "fusee/solid/cut.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <exception>
#include <new>

#include "fusee/solid/slivers.h"
#include "surface_mesh.h"

namespace fusee::solid {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoints = SurfaceMesh::Property_map<SurfaceMesh::Vertex_index, Exact::Point_3>;

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

}  // namespace

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
} catch (const std::bad_alloc&) {
    throw;  // says nothing of the solid
} catch (const std::exception&) {
    return std::nullopt;  // CGAL throws on an input that intersects itself; `validate` says so to the caller
}

}  // namespace fusee::solid
