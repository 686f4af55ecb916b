#include "fusee/solid/crossings.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>

#include "fusee/solid/separation.h"
#include "surface_mesh.h"

namespace fusee::solid {

Crossings crossings(const Mesh& mesh, const std::vector<std::uint32_t>& flat, std::size_t most) {
    if (SurfaceMesh surface; !to_surface_mesh(mesh, surface)) return {.manifold = false};
    const auto doubtful = doubtful_triangles(mesh, flat, most);
    if (!doubtful) return {.complete = false};
    if (doubtful->empty()) return {};
    SurfaceMesh surface;  // made again: both searches at once would take twice the memory
    to_surface_mesh(mesh, surface);
    std::vector<SurfaceMesh::Face_index> faces;  // numbered like the triangles
    for (const std::uint32_t number : *doubtful) faces.emplace_back(number);
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(faces, surface, std::back_inserter(found));
    Crossings result;
    for (const auto& [a, b] : found) {
        const auto first = static_cast<std::uint32_t>(a.idx()), second = static_cast<std::uint32_t>(b.idx());
        result.pairs.push_back({std::min(first, second), std::max(first, second)});
    }
    std::sort(result.pairs.begin(), result.pairs.end());
    return result;
}

}  // namespace fusee::solid
