#include <exception>
#include <new>

#include "corefinement.h"
#include "exact_points.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/mesh_faults.h"
#include "local_cut.h"

namespace fusee::solid {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

/// The whole body with every whole tool.
std::optional<Mesh> cut_wholly(const Mesh& body, const std::vector<Mesh>& tools) {
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
    for (const auto v : solid.vertices()) {
        const Vec3 p = rounded(solid_map.points[v]);
        solid.point(v) = {p[0], p[1], p[2]};
    }
    return from_surface_mesh(solid);
}

}  // namespace

std::optional<Mesh> cut(const Mesh& body, const std::vector<Mesh>& tools) try {
    if (tools.empty()) return body;
    std::optional<Mesh> left = cut_locally(body, tools);
    if (!left) left = cut_wholly(body, tools);
    return left ? without_slivers(*left) : std::nullopt;
} catch (const std::bad_alloc&) {
    throw;  // says nothing of the solid
} catch (const std::exception&) {
    return std::nullopt;  // CGAL throws on an input that intersects itself; `validate` says so to the caller
}

}  // namespace fusee::solid
