#pragma once
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// @return false if the triangles do not form a manifold
inline bool to_surface_mesh(const Mesh& mesh, SurfaceMesh& out) {
    for (const Vec3& p : mesh.points_mm) out.add_vertex({p[0], p[1], p[2]});
    for (const Triangle& t : mesh.triangles)
        if (out.add_face(SurfaceMesh::Vertex_index(t[0]), SurfaceMesh::Vertex_index(t[1]), SurfaceMesh::Vertex_index(t[2])) ==
            SurfaceMesh::null_face())
            return false;
    return true;
}

}  // namespace fusee::solid
