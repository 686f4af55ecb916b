#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <deque>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

namespace {

using FlatKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, FlatKernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<FlatKernel, CGAL::Triangulation_face_base_with_info_2<int, FlatKernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<FlatKernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

constexpr int kUnseen = -1;

void constrain(Triangulation& cdt, const Mesh& mesh, const VertexRing& ring) {
    std::vector<Triangulation::Vertex_handle> handles;
    for (const std::uint32_t v : ring) {
        const Vec3& p = mesh.points_mm[v];
        handles.push_back(cdt.insert({p[0], p[1]}, handles.empty() ? Triangulation::Face_handle() : handles.back()->face()));
        handles.back()->info() = v;
    }
    for (std::size_t i = 0; i < handles.size(); ++i) cdt.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
}

/// Nesting depth of every face: even = outside, odd = material. It grows at each constrained edge, from outside inwards.
void mark_depth(Triangulation& cdt) {
    for (auto f : cdt.all_face_handles()) f->info() = kUnseen;
    std::deque<std::pair<Triangulation::Face_handle, int>> next{{cdt.infinite_face(), 0}};
    while (!next.empty()) {
        const auto [face, depth] = next.front();
        next.pop_front();
        if (face->info() != kUnseen) continue;
        face->info() = depth;
        for (int i = 0; i < 3; ++i) {
            const auto neighbour = face->neighbor(i);
            if (neighbour->info() != kUnseen) continue;
            if (face->is_constrained(i))
                next.emplace_back(neighbour, depth + 1);
            else
                next.emplace_front(neighbour, depth);
        }
    }
}

}  // namespace

bool fill_face(Mesh& mesh, const VertexRing& outer, const std::vector<VertexRing>& holes, bool up) {
    Triangulation cdt;
    try {
        constrain(cdt, mesh, outer);
        for (const VertexRing& hole : holes) constrain(cdt, mesh, hole);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
        return false;
    }
    mark_depth(cdt);
    for (auto f : cdt.finite_face_handles()) {
        if (f->info() % 2 == 0) continue;
        const std::uint32_t a = f->vertex(0)->info(), b = f->vertex(1)->info(), c = f->vertex(2)->info();
        mesh.triangles.push_back(up ? Triangle{a, b, c} : Triangle{a, c, b});
    }
    return true;
}

VertexRing add_ring(Mesh& mesh, const std::vector<std::array<double, 2>>& ring, double z_mm) {
    VertexRing numbers;
    for (const auto& p : ring) {
        numbers.push_back(static_cast<std::uint32_t>(mesh.points_mm.size()));
        mesh.points_mm.push_back({p[0], p[1], z_mm});
    }
    return numbers;
}

void add_wall_between(Mesh& mesh, const VertexRing& lower, const VertexRing& upper, bool outward) {
    for (std::size_t i = 0; i < lower.size(); ++i) {
        const std::size_t j = (i + 1) % lower.size();
        const Triangle first{lower[i], lower[j], upper[j]}, second{lower[i], upper[j], upper[i]};
        for (Triangle t : {first, second}) {
            if (!outward) std::swap(t[1], t[2]);
            mesh.triangles.push_back(t);
        }
    }
}

Mesh prism(const std::vector<std::array<double, 2>>& ring, double z_low_mm, double z_high_mm) {
    Mesh mesh;
    const VertexRing lower = add_ring(mesh, ring, z_low_mm), upper = add_ring(mesh, ring, z_high_mm);
    add_wall_between(mesh, lower, upper, true);
    fill_face(mesh, lower, {}, false);
    fill_face(mesh, upper, {}, true);
    return mesh;
}

}  // namespace fusee::solid
