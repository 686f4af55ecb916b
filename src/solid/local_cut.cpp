#include "local_cut.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

#include "corefinement.h"
#include "exact_points.h"

namespace fusee::solid {

namespace {

using Face = SurfaceMesh::Face_index;
using Vertex = SurfaceMesh::Vertex_index;
using Halfedge = SurfaceMesh::Halfedge_index;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The body between two cuts. Points that a cut made have their exact places beside the rounded ones.
struct Body {
    Mesh mesh;
    std::unordered_map<std::uint32_t, Exact::Point_3> exact;

    std::uint32_t add(const Exact::Point_3& p) {
        const auto number = static_cast<std::uint32_t>(mesh.points_mm.size());
        mesh.points_mm.push_back(rounded(p));
        exact.emplace(number, p);
        return number;
    }
};

/// One of two surfaces that are cut with each other.
struct Surface {
    SurfaceMesh mesh;
    ExactMap exact;
    SurfaceMesh::Property_map<SurfaceMesh::Edge_index, bool> on_curve;  ///< edges where both surfaces meet
    std::vector<std::uint32_t> numbers;                                 ///< of the vertices in the body, as far as known

    /// @returns false if the triangles form no manifold
    [[nodiscard]] bool fill(const Mesh& triangles) {
        if (!to_surface_mesh(triangles, mesh)) return false;
        exact = ExactMap(mesh);
        on_curve = mesh.add_property_map<SurfaceMesh::Edge_index, bool>("e:curve", false).first;
        return true;
    }
    [[nodiscard]] std::uint32_t& number(Vertex v) {
        if (v >= numbers.size()) numbers.resize(mesh.num_vertices(), kNone);
        return numbers[v];
    }
};

bool boxes_apart(const Box& a, const Box& b) {
    for (std::size_t i = 0; i < 3; ++i)
        if (a.high_mm[i] < b.low_mm[i] || a.low_mm[i] > b.high_mm[i]) return true;
    return false;
}

Box box_of(const Mesh& mesh, const Triangle& t) {
    Box box{mesh.points_mm[t[0]], mesh.points_mm[t[0]]};
    for (const std::uint32_t v : {t[1], t[2]})
        for (std::size_t i = 0; i < 3; ++i) {
            box.low_mm[i] = std::min(box.low_mm[i], mesh.points_mm[v][i]);
            box.high_mm[i] = std::max(box.high_mm[i], mesh.points_mm[v][i]);
        }
    return box;
}

/// Takes the triangles within the box out of the body. They are a surface with a border, which the box does not touch.
[[nodiscard]] bool take_patch(Body& body, const Box& box, Surface& patch) {
    Mesh near;
    std::vector<Triangle> far;
    std::vector<std::uint32_t> place(body.mesh.points_mm.size(), kNone);
    for (const Triangle& t : body.mesh.triangles) {
        if (boxes_apart(box_of(body.mesh, t), box)) {
            far.push_back(t);
            continue;
        }
        for (const std::uint32_t v : t)
            if (place[v] == kNone) {
                place[v] = static_cast<std::uint32_t>(near.points_mm.size());
                near.points_mm.push_back(body.mesh.points_mm[v]);
                patch.numbers.push_back(v);
            }
        near.triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
    }
    body.mesh.triangles = std::move(far);
    if (!patch.fill(near)) return false;
    for (std::size_t i = 0; i < patch.numbers.size(); ++i)
        if (const auto known = body.exact.find(patch.numbers[i]); known != body.exact.end())
            patch.exact.points[Vertex(static_cast<std::uint32_t>(i))] = known->second;
    return true;
}

using Sides = std::map<Face, bool>;

/// The side of every face: it changes across the common curve. None if that contradicts itself or leaves a face out.
std::optional<Sides> spread(const Surface& surface, Sides known) {
    std::deque<Face> open;
    for (const auto& [face, side] : known) open.push_back(face);
    for (; !open.empty(); open.pop_front()) {
        const bool side = known[open.front()];
        for (const Halfedge h : CGAL::halfedges_around_face(surface.mesh.halfedge(open.front()), surface.mesh)) {
            const Face next = surface.mesh.face(surface.mesh.opposite(h));
            if (next == SurfaceMesh::null_face()) continue;
            const bool expected = side != surface.on_curve[surface.mesh.edge(h)];
            const auto [found, fresh] = known.try_emplace(next, expected);
            if (fresh) open.push_back(next);
            if (found->second != expected) return std::nullopt;
        }
    }
    return known.size() == surface.mesh.number_of_faces() ? std::optional(std::move(known)) : std::nullopt;
}

/// Is a patch's face in the tool? Those at its border are not.
std::optional<Sides> in_tool(const Surface& patch) {
    Sides known;
    for (const Halfedge h : patch.mesh.halfedges())
        if (patch.mesh.is_border(h)) known[patch.mesh.face(patch.mesh.opposite(h))] = false;
    return spread(patch, std::move(known));
}

/// Does a face that ends at the edge h of the body, with this far corner, begin inside the body? None if it lies in one of the two planes.
std::optional<bool> begins_inside(const Surface& patch, Halfedge h, const Exact::Point_3& corner) {
    const SurfaceMesh& mesh = patch.mesh;
    const auto at = [&](Vertex v) -> const Exact::Point_3& { return patch.exact.points[v]; };
    const auto &from = at(mesh.source(h)), &to = at(mesh.target(h)), &left = at(mesh.target(mesh.next(h))),
               &right = at(mesh.target(mesh.next(mesh.opposite(h))));
    const auto bend = CGAL::orientation(from, to, left, right), over_left = CGAL::orientation(from, to, left, corner),
               over_right = CGAL::orientation(to, from, right, corner);
    if (over_left == CGAL::COPLANAR || over_right == CGAL::COPLANAR) return std::nullopt;
    const bool below_left = over_left == CGAL::NEGATIVE, below_right = over_right == CGAL::NEGATIVE;
    if (bend == CGAL::COPLANAR) return below_left == below_right ? std::optional(below_left) : std::nullopt;
    return bend == CGAL::NEGATIVE ? below_left && below_right : below_left || below_right;
}

/// Gives the tool's vertices on the common curve their numbers in the body. @returns false if one has no counterpart
bool match_curve(Body& body, Surface& patch, Surface& tool, std::map<std::uint32_t, Vertex>& on_patch) {
    std::map<Exact::Point_3, Vertex> places;
    for (const auto e : patch.mesh.edges())
        if (patch.on_curve[e])
            for (const unsigned end : {0U, 1U}) places.emplace(patch.exact.points[patch.mesh.vertex(e, end)], patch.mesh.vertex(e, end));
    for (const auto& [point, v] : places) {
        if (patch.number(v) == kNone) patch.number(v) = body.add(point);
        on_patch.emplace(patch.number(v), v);
    }
    for (const auto e : tool.mesh.edges())
        for (const unsigned end : {0U, 1U}) {
            if (!tool.on_curve[e]) continue;
            const auto found = places.find(tool.exact.points[tool.mesh.vertex(e, end)]);
            if (found == places.end()) return false;
            tool.number(tool.mesh.vertex(e, end)) = patch.number(found->second);
        }
    return true;
}

/// Is a tool's face in the body? One place where both surfaces meet decides.
std::optional<Sides> in_body(const Surface& patch, Surface& tool, const std::map<std::uint32_t, Vertex>& on_patch) {
    for (const auto e : tool.mesh.edges()) {
        if (!tool.on_curve[e]) continue;
        const Halfedge h = tool.mesh.halfedge(e);
        const Halfedge same =
            patch.mesh.halfedge(on_patch.at(tool.number(tool.mesh.source(h))), on_patch.at(tool.number(tool.mesh.target(h))));
        if (same == SurfaceMesh::null_halfedge() || patch.mesh.is_border(patch.mesh.edge(same))) return std::nullopt;
        if (const auto inside = begins_inside(patch, same, tool.exact.points[tool.mesh.target(tool.mesh.next(h))]))
            return spread(tool, {{tool.mesh.face(h), *inside}});
    }
    return std::nullopt;
}

/// Adds the faces of one side to the body.
void add_faces(Body& body, Surface& surface, const Sides& sides, bool side, bool reversed) {
    for (const Face f : surface.mesh.faces()) {
        if (sides.at(f) != side) continue;
        Triangle t{};
        std::size_t i = 0;
        for (const Vertex v : CGAL::vertices_around_face(surface.mesh.halfedge(f), surface.mesh)) {
            std::uint32_t& number = surface.number(v);
            if (number == kNone) number = body.add(surface.exact.points[v]);
            t[i++] = number;
        }
        if (reversed) std::swap(t[1], t[2]);
        body.mesh.triangles.push_back(t);
    }
}

[[nodiscard]] bool take_away(Body& body, const Mesh& knife) {
    Surface patch, tool;
    if (!take_patch(body, bounding_box(knife), patch) || !tool.fill(knife)) return false;
    CGAL::Polygon_mesh_processing::corefine(patch.mesh, tool.mesh,
                                            CGAL::parameters::vertex_point_map(patch.exact).edge_is_constrained_map(patch.on_curve),
                                            CGAL::parameters::vertex_point_map(tool.exact).edge_is_constrained_map(tool.on_curve));
    std::map<std::uint32_t, Vertex> on_patch;
    if (!match_curve(body, patch, tool, on_patch)) return false;
    const auto cut_off = in_tool(patch), left_over = in_body(patch, tool, on_patch);
    if (!cut_off || !left_over) return false;
    add_faces(body, patch, *cut_off, false, false);
    add_faces(body, tool, *left_over, true, true);
    return true;
}

/// The mesh without the points that no triangle names.
Mesh compact(const Mesh& mesh) {
    Mesh out;
    std::vector<std::uint32_t> place(mesh.points_mm.size(), kNone);
    for (Triangle t : mesh.triangles) {
        for (std::uint32_t& v : t) {
            if (place[v] == kNone) {
                place[v] = static_cast<std::uint32_t>(out.points_mm.size());
                out.points_mm.push_back(mesh.points_mm[v]);
            }
            v = place[v];
        }
        out.triangles.push_back(t);
    }
    return out;
}

}  // namespace

std::optional<Mesh> cut_locally(const Mesh& body, const std::vector<Mesh>& tools) {
    Body left{body, {}};
    for (const Mesh& tool : tools)
        if (!take_away(left, tool)) return std::nullopt;
    return compact(left.mesh);
}

}  // namespace fusee::solid
