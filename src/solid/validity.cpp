#include "fusee/solid/validity.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "fusee/solid/mesh_faults.h"
#include "surface_mesh.h"

namespace fusee::solid {

namespace pmp = CGAL::Polygon_mesh_processing;

std::string Validity::line() const {
    return fmt::format("{}, {}, {} component{}, {}", closed ? "closed" : "not closed", outward ? "outward" : "not outward", components,
                       components == 1 ? "" : "s", self_intersecting ? "intersects itself" : "no self-intersection");
}

namespace {

/// Quick proofs first: exact predicates decide on what they leave open.
bool intersects_itself(const Mesh& mesh, const SurfaceMesh& surface) {
    std::vector<SurfaceMesh::Face_index> faces;  // numbered like the triangles
    for (const std::uint32_t number : doubtful_triangles(mesh)) faces.emplace_back(number);
    return pmp::does_self_intersect<CGAL::Sequential_tag>(faces, surface);
}

/// Do closed faces that meet nowhere bound a volume from outside? For a single component the sign of its volume says so.
bool faces_outward(const Mesh& mesh, const SurfaceMesh& surface, std::size_t components) {
    const Box box = bounding_box(mesh);
    double clear = 1e-6;  // of the box's volume: far above any rounding
    for (std::size_t k = 0; k < 3; ++k) clear *= box.high_mm[k] - box.low_mm[k];
    if (const double volume = volume_mm3(mesh); components == 1 && std::abs(volume) > clear) return volume > 0.0;
    return pmp::does_bound_a_volume(surface) && pmp::is_outward_oriented(surface);
}

/// The first of all intersecting triangles. The order in which pairs are found is not a property of the mesh.
std::optional<Vec3> meeting(const Mesh& mesh, const SurfaceMesh& surface) {
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
    pmp::self_intersections<CGAL::Sequential_tag>(surface, std::back_inserter(pairs));
    if (pairs.empty()) return std::nullopt;
    const auto low = [](const auto& pair) { return std::min(pair.first, pair.second); };
    const auto first = std::min_element(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) { return low(a) < low(b); });
    return mesh.points_mm[mesh.triangles[low(*first)][0]];
}

}  // namespace

Validity validate(const Mesh& mesh) {
    Validity validity;
    SurfaceMesh surface;
    if (!to_surface_mesh(mesh, surface)) return validity;
    validity.closed = CGAL::is_closed(surface);
    const auto component = surface.add_property_map<SurfaceMesh::Face_index, std::size_t>("f:component").first;
    validity.components = pmp::connected_components(surface, component);
    validity.self_intersecting = intersects_itself(mesh, surface);
    if (validity.self_intersecting) validity.meeting_mm = meeting(mesh, surface);
    validity.outward = validity.closed && !validity.self_intersecting && faces_outward(mesh, surface, validity.components);
    return validity;
}

core::Finding invalid_solid(const Validity& validity, const std::string& solid, const std::string& part, core::Suggestion suggestion) {
    core::Finding f = core::error_finding("solid.validity", solid + " is not valid: " + validity.line(), validity.good() ? 1.0 : 0.0,
                                          core::Bound::kAtLeast, 1.0, "");
    f.where = part;
    if (const auto& at = validity.meeting_mm) {
        f.where += fmt::format(", its faces intersect at x {:.2f}, y {:.2f}, z {:.2f} mm", (*at)[0], (*at)[1], (*at)[2]);
        f.place = core::Place{std::atan2((*at)[1], (*at)[0]), *at};
    }
    f.suggestion = std::move(suggestion);
    f.source = "CGAL: closed, oriented, one component, no self-intersection";
    return f;
}

}  // namespace fusee::solid
