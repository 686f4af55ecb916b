#include "fusee/solid/validity.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <fmt/format.h>

#include "surface_mesh.h"

namespace fusee::solid {

namespace pmp = CGAL::Polygon_mesh_processing;

std::string Validity::line() const {
    return fmt::format("{}, {}, {} component{}, {}", closed ? "closed" : "not closed", outward ? "outward" : "not outward", components,
                       components == 1 ? "" : "s", self_intersecting ? "intersects itself" : "no self-intersection");
}

Validity validate(const Mesh& mesh) {
    Validity validity;
    SurfaceMesh surface;
    if (!to_surface_mesh(mesh, surface)) return validity;
    validity.closed = CGAL::is_closed(surface);
    const auto component = surface.add_property_map<SurfaceMesh::Face_index, std::size_t>("f:component").first;
    validity.components = pmp::connected_components(surface, component);
    validity.self_intersecting = pmp::does_self_intersect<CGAL::Sequential_tag>(surface);
    validity.outward =
        validity.closed && !validity.self_intersecting && pmp::does_bound_a_volume(surface) && pmp::is_outward_oriented(surface);
    return validity;
}

}  // namespace fusee::solid
