#include "fusee/solid/crossings.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>

#include "surface_mesh.h"

namespace fusee::solid {

std::optional<std::vector<std::array<std::uint32_t, 2>>> crossings(const Mesh& mesh, const std::vector<std::uint32_t>& flat) {
    SurfaceMesh surface;
    if (!to_surface_mesh(mesh, surface)) return std::nullopt;
    std::vector<SurfaceMesh::Face_index> faces;  // numbered like the triangles
    for (const auto face : surface.faces())
        if (!std::binary_search(flat.begin(), flat.end(), static_cast<std::uint32_t>(face.idx()))) faces.push_back(face);
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(faces, surface, std::back_inserter(found));
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (const auto& [a, b] : found) {
        const auto first = static_cast<std::uint32_t>(a.idx()), second = static_cast<std::uint32_t>(b.idx());
        pairs.push_back({std::min(first, second), std::max(first, second)});
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace fusee::solid
