#include "fusee/solid/crossings.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <exception>

#include "surface_mesh.h"

namespace fusee::solid {

namespace {

using FaceBox = CGAL::Box_intersection_d::Box_d<double, 3>;

struct TooMany final : std::exception {};

/// Counting is cheap compared to the predicates. Only a count can end CGAL's search before it has checked every pair.
bool more_pairs_than(std::size_t most, const Mesh& mesh, const std::vector<SurfaceMesh::Face_index>& faces) {
    std::vector<FaceBox> boxes;
    boxes.reserve(faces.size());
    for (const auto face : faces) {
        FaceBox box;
        for (const std::uint32_t p : mesh.triangles[face.idx()]) {
            Vec3 at = mesh.points_mm[p];
            box.extend(at.data());
        }
        boxes.push_back(box);
    }
    std::size_t count = 0;
    try {
        CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const FaceBox&, const FaceBox&) {
            if (++count > most) throw TooMany();
        });
    } catch (const TooMany&) {
        return true;
    }
    return false;
}

}  // namespace

Crossings crossings(const Mesh& mesh, const std::vector<std::uint32_t>& flat, std::size_t most) {
    SurfaceMesh surface;
    if (!to_surface_mesh(mesh, surface)) return {.manifold = false};
    std::vector<SurfaceMesh::Face_index> faces;  // numbered like the triangles
    for (const auto face : surface.faces())
        if (!std::binary_search(flat.begin(), flat.end(), static_cast<std::uint32_t>(face.idx()))) faces.push_back(face);
    if (more_pairs_than(most, mesh, faces)) return {.complete = false};
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
