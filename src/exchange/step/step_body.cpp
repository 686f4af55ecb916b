#include "step_body.h"

#include <BRep_Tool.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <limits>
#include <unordered_map>
#include <vector>

#include "fusee/core/disjoint_sets.h"

namespace fusee::exchange {

namespace {

constexpr std::uint32_t kNone = ~0U;

/// The points and triangles of one body. Numbers are given to vertices, nodes of edges and nodes inside of faces; those that a face's
/// triangulation has as one node are one point.
class BodyMesh {
public:
    /// @returns false if the face has no triangulation
    bool add(const TopoDS_Face& face) {
        TopLoc_Location location;
        const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
        if (mesh.IsNull()) return false;
        std::vector<std::uint32_t> number(static_cast<std::size_t>(mesh->NbNodes()) + 1, kNone);  // by node, which count from 1
        for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next())
            number_edge(TopoDS::Edge(edge.Current()), mesh, location, number);
        for (int i = 1; i <= mesh->NbNodes(); ++i)
            if (number[static_cast<std::size_t>(i)] == kNone)
                number[static_cast<std::size_t>(i)] = fresh(mesh->Node(i).Transformed(location));
        // A mirrored placement turns the triangles over.
        const bool turned = (face.Orientation() == TopAbs_REVERSED) != (location.Transformation().VectorialPart().Determinant() < 0.0);
        for (int i = 1; i <= mesh->NbTriangles(); ++i) {
            std::array<int, 3> node{};
            mesh->Triangle(i).Get(node[0], node[1], node[2]);
            if (turned) std::swap(node[1], node[2]);
            triangles_.push_back({number[static_cast<std::size_t>(node[0])], number[static_cast<std::size_t>(node[1])],
                                  number[static_cast<std::size_t>(node[2])]});
        }
        return true;
    }

    /// Triangles of which two corners are one point have vanished: their neighbours meet in the edge that is left.
    [[nodiscard]] solid::Mesh mesh() {
        solid::Mesh out;
        std::vector<std::uint32_t> point(points_.size(), kNone);
        for (const solid::Triangle& numbers : triangles_) {
            solid::Triangle t{};
            for (std::size_t k = 0; k < 3; ++k) t[k] = same_.find(numbers[k]);
            if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
            for (std::uint32_t& corner : t) {
                if (point[corner] == kNone) {
                    point[corner] = static_cast<std::uint32_t>(out.points_mm.size());
                    out.points_mm.push_back(points_[corner]);
                }
                corner = point[corner];
            }
            out.triangles.push_back(t);
        }
        return out;
    }

private:
    std::uint32_t fresh(const gp_Pnt& at) {
        points_.push_back({at.X(), at.Y(), at.Z()});
        return same_.add();
    }
    std::uint32_t number_of(const TopoDS_Vertex& vertex) {
        const auto [found, first] = vertices_.try_emplace(vertex, kNone);
        if (first) found->second = fresh(BRep_Tool::Pnt(vertex));
        return found->second;
    }
    /// The numbers of an edge's nodes in the direction of its parameter; a degenerate edge is its vertex.
    const std::vector<std::uint32_t>& numbers_of(const TopoDS_Edge& edge, const Handle(Poly_PolygonOnTriangulation) & nodes,
                                                 const Handle(Poly_Triangulation) & mesh, const TopLoc_Location& location) {
        const auto [found, first] = edges_.try_emplace(edge, std::vector<std::uint32_t>{});
        if (!first) return found->second;
        const auto count = static_cast<std::size_t>(nodes->NbNodes());
        const TopoDS_Vertex begin = TopExp::FirstVertex(edge), end = TopExp::LastVertex(edge);
        std::vector<std::uint32_t>& numbers = found->second;
        numbers.assign(count, kNone);
        if (!begin.IsNull()) numbers.front() = number_of(begin);
        if (!end.IsNull()) numbers.back() = number_of(end);
        for (std::size_t i = 0; i < count; ++i) {
            if (BRep_Tool::Degenerated(edge) && !begin.IsNull())
                numbers[i] = number_of(begin);
            else if (numbers[i] == kNone)
                numbers[i] = fresh(mesh->Node(nodes->Nodes()(static_cast<int>(i) + 1)).Transformed(location));
        }
        return numbers;
    }
    void number_edge(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & mesh, const TopLoc_Location& location,
                     std::vector<std::uint32_t>& number) {
        const Handle(Poly_PolygonOnTriangulation)& nodes = BRep_Tool::PolygonOnTriangulation(edge, mesh, location);
        if (nodes.IsNull()) return;
        const std::vector<std::uint32_t>& numbers = numbers_of(edge, nodes, mesh, location);
        const auto count = std::min(numbers.size(), static_cast<std::size_t>(nodes->NbNodes()));
        for (std::size_t i = 0; i < count; ++i) {
            std::uint32_t& known = number[static_cast<std::size_t>(nodes->Nodes()(static_cast<int>(i) + 1))];
            if (known == kNone) known = numbers[i];
            same_.join(known, numbers[i]);
        }
    }

    struct Hash {
        std::size_t operator()(const TopoDS_Shape& s) const {
            return static_cast<std::size_t>(TopTools_ShapeMapHasher::HashCode(s, std::numeric_limits<int>::max()));
        }
    };
    struct Same {
        bool operator()(const TopoDS_Shape& a, const TopoDS_Shape& b) const { return a.IsSame(b); }
    };
    std::unordered_map<TopoDS_Shape, std::uint32_t, Hash, Same> vertices_;
    std::unordered_map<TopoDS_Shape, std::vector<std::uint32_t>, Hash, Same> edges_;
    std::vector<solid::Vec3> points_;
    core::DisjointSets same_;  ///< numbers that are one point
    std::vector<solid::Triangle> triangles_;
};

}  // namespace

std::optional<solid::Mesh> mesh_of_body(const TopoDS_Shape& body) {
    BodyMesh mesh;
    for (TopExp_Explorer face(body, TopAbs_FACE); face.More(); face.Next())
        if (!mesh.add(TopoDS::Face(face.Current()))) return std::nullopt;
    return mesh.mesh();
}

}  // namespace fusee::exchange
