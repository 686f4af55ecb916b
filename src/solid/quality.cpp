#include "fusee/solid/quality.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/core/units.h"

namespace fusee::solid {

namespace {
struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using OpenTriMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
}  // namespace

Quality measure_quality(const Mesh& mesh) {
    OpenTriMesh om;
    for (const Vec3& p : mesh.points_mm) om.add_vertex({p[0], p[1], p[2]});
    for (const Triangle& t : mesh.triangles) om.add_face(om.vertex_handle(t[0]), om.vertex_handle(t[1]), om.vertex_handle(t[2]));
    Quality q;
    q.triangles = om.n_faces();
    q.vertices = om.n_vertices();
    q.euler = static_cast<int>(om.n_vertices()) - static_cast<int>(om.n_edges()) + static_cast<int>(om.n_faces());
    q.boundary_edges = static_cast<std::size_t>(std::count_if(om.edges_begin(), om.edges_end(), [&](auto e) { return om.is_boundary(e); }));
    q.shortest_edge_mm = std::numeric_limits<double>::infinity();
    for (const auto e : om.edges()) q.shortest_edge_mm = std::min(q.shortest_edge_mm, om.calc_edge_length(e));
    q.smallest_angle_deg = 180.0;
    for (const auto h : om.halfedges())
        if (!om.is_boundary(h)) q.smallest_angle_deg = std::min(q.smallest_angle_deg, core::deg_from_rad(om.calc_sector_angle(h)));
    return q;
}

}  // namespace fusee::solid
