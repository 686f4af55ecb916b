#pragma once
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// @return false if the triangles do not form a manifold
inline bool to_surface_mesh(const Mesh& mesh, SurfaceMesh& out) {
    out.reserve(static_cast<SurfaceMesh::size_type>(mesh.points_mm.size()),
                static_cast<SurfaceMesh::size_type>(mesh.points_mm.size() + mesh.triangles.size()),
                static_cast<SurfaceMesh::size_type>(mesh.triangles.size()));
    for (const Vec3& p : mesh.points_mm) out.add_vertex({p[0], p[1], p[2]});
    for (const Triangle& t : mesh.triangles)
        if (out.add_face(SurfaceMesh::Vertex_index(t[0]), SurfaceMesh::Vertex_index(t[1]), SurfaceMesh::Vertex_index(t[2])) ==
            SurfaceMesh::null_face())
            return false;
    return true;
}

inline Mesh from_surface_mesh(const SurfaceMesh& mesh) {
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

}  // namespace fusee::solid
