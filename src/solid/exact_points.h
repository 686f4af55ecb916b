#pragma once
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "surface_mesh.h"

namespace fusee::solid {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

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
    SurfaceMesh::Property_map<key_type, Exact::Point_3> points;

private:
    SurfaceMesh* mesh_ = nullptr;
};

/// A lazy number's double is the middle of the interval known of it, and that interval is as narrow as earlier predicates needed, in an
/// order of addresses: only the exact number's double is the same from run to run.
inline Vec3 rounded(const Exact::Point_3& p) {
    return {CGAL::to_double(p.x().exact()), CGAL::to_double(p.y().exact()), CGAL::to_double(p.z().exact())};
}

}  // namespace fusee::solid
