#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>

#include "fusee/solid/mesh_faults.h"
#include "surface_mesh.h"

namespace fusee::solid {

namespace {

/// Do two triangles meet in corners or an edge only, whose points are at one place without being one point? Then they touch.
bool only_touch(const Mesh& mesh, std::uint32_t first, std::uint32_t second) {
    Mesh pair{{}, {mesh.triangles[first], mesh.triangles[second]}};
    for (Triangle& t : pair.triangles)
        for (std::uint32_t& corner : t) {
            const Vec3& at = mesh.points_mm[corner];
            const auto found = std::find(pair.points_mm.begin(), pair.points_mm.end(), at);
            corner = static_cast<std::uint32_t>(found - pair.points_mm.begin());
            if (found == pair.points_mm.end()) pair.points_mm.push_back(at);
        }
    if (pair.points_mm.size() > 5 || pair.points_mm.size() < 4) return false;
    SurfaceMesh surface;
    if (!to_surface_mesh(pair, surface)) {  // both run the same way along the edge
        std::swap(pair.triangles[1][0], pair.triangles[1][1]);
        surface.clear();
        if (!to_surface_mesh(pair, surface)) return false;
    }
    return !CGAL::Polygon_mesh_processing::does_self_intersect<CGAL::Sequential_tag>(surface);
}

}  // namespace

Crossings crossings(const Mesh& mesh, const std::vector<std::uint32_t>& flat, std::size_t most, bool manifold) {
    if (SurfaceMesh surface; !manifold && !to_surface_mesh(mesh, surface)) return {.manifold = false};
    const auto doubtful = doubtful_triangles(mesh, flat, most);
    if (!doubtful) return {.complete = false};
    Mesh part{mesh.points_mm, {}};
    for (const std::uint32_t number : *doubtful) part.triangles.push_back(mesh.triangles[number]);
    SurfaceMesh surface;
    if (!to_surface_mesh(part, surface)) return {.manifold = false};
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> found;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(surface, std::back_inserter(found));
    Crossings result;
    for (const auto& [a, b] : found) {
        const auto [first, second] = std::minmax((*doubtful)[a.idx()], (*doubtful)[b.idx()]);
        if (!only_touch(mesh, first, second)) result.pairs.push_back({first, second});
    }
    std::sort(result.pairs.begin(), result.pairs.end());
    return result;
}

}  // namespace fusee::solid
