#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "brep/kernel/measure.h"
#include "fusee/core/disjoint_sets.h"
#include "fusee/core/error.h"
#include "fusee/solid/mesh.h"
#include "kernel.h"
#include "step_model.h"

class TopoDS_Shape;

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

/// The triangles of a body that BRepMesh has tessellated, with one point for each vertex and each node of an edge. Faces share these, so
/// that the mesh is connected as the B-rep is; no point is found by its coordinates. Seams and degenerate edges (poles, apexes) are closed.
/// @returns nothing if a face has no triangulation
std::optional<solid::Mesh> mesh_of_body(const TopoDS_Shape& body) {
    BodyMesh mesh;
    for (TopExp_Explorer face(body, TopAbs_FACE); face.More(); face.Next())
        if (!mesh.add(TopoDS::Face(face.Current()))) return std::nullopt;
    return mesh.mesh();
}

constexpr double kSewn_mm = 1e-3;               // edges of loose faces that are one edge
constexpr double kOfDiagonal = 2e-5;            // chords of a body of metres: a part of its size
constexpr std::size_t kManyTriangles = 50'000;  // a finer tessellation of such a body is not tried
constexpr double kFiner[] = {1, 0.4, 0.1};      // chords where a coarser tessellation is not sound

/// All parts of a kind, those within a `outer` left out.
std::vector<TopoDS_Shape> parts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, TopAbs_ShapeEnum outer = TopAbs_SHAPE) {
    std::vector<TopoDS_Shape> all;
    for (TopExp_Explorer at(shape, kind, outer); at.More(); at.Next()) all.push_back(at.Current());
    return all;
}

/// @returns the diagonal of its box [mm]; 0 if it has none
double size_of(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box, false);
    return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

/// Faces with edges of their own, as shells whose faces share them; closed ones face outward.
std::vector<TopoDS_Shape> sewn(const std::vector<TopoDS_Shape>& faces) {
    BRepBuilderAPI_Sewing sewing(kSewn_mm);
    for (const TopoDS_Shape& face : faces) sewing.Add(face);
    sewing.Perform();
    std::vector<TopoDS_Shape> bodies = parts(sewing.SewedShape(), TopAbs_SHELL);
    for (TopoDS_Shape& shell : bodies)
        if (BRep_Tool::IsClosed(shell) && brep::volume_mm3(shell) < 0.0) shell.Reverse();
    const std::vector<TopoDS_Shape> single = parts(sewing.SewedShape(), TopAbs_FACE, TopAbs_SHELL);
    bodies.insert(bodies.end(), single.begin(), single.end());
    return bodies;
}

/// The solids, the closed shells that bound none, and what is left, sewn.
std::vector<TopoDS_Shape> bodies_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Shape> bodies = parts(shape, TopAbs_SOLID), loose = parts(shape, TopAbs_FACE, TopAbs_SHELL);
    for (const TopoDS_Shape& shell : parts(shape, TopAbs_SHELL, TopAbs_SOLID)) {
        if (BRep_Tool::IsClosed(shell)) {
            bodies.push_back(shell);
            continue;
        }
        const std::vector<TopoDS_Shape> faces = parts(shell, TopAbs_FACE);
        loose.insert(loose.end(), faces.begin(), faces.end());
    }
    const std::vector<TopoDS_Shape> rest = loose.empty() ? loose : sewn(loose);
    bodies.insert(bodies.end(), rest.begin(), rest.end());
    return bodies;
}

/// A mesh of a body, and the faults that it has.
struct Attempt {
    std::optional<solid::Mesh> mesh;
    std::size_t faults = std::numeric_limits<std::size_t>::max();
};

/// The first sound one of ever finer tessellations, else the best. No mesh where OpenCASCADE makes none.
Attempt tessellated(const TopoDS_Shape& body, SettleMesh settle) {
    const bool valid = BRepCheck_Analyzer(body).IsValid(), closed = brep::count_solids(body) > 0 || BRep_Tool::IsClosed(body);
    const double coarse_mm = std::max(kTessellation_mm, kOfDiagonal * size_of(body));
    Attempt best;
    for (const double finer : kFiner) {
        BRepTools::Clean(body);
        const BRepMesh_IncrementalMesh tessellation(body, finer * coarse_mm, false, kTessellation_rad);
        Attempt now{mesh_of_body(body)};
        if (now.mesh) now.faults = settle(*now.mesh, valid);
        if (!best.mesh || now.faults < best.faults) best = std::move(now);
        if (best.mesh && (best.faults == 0 || !closed || best.mesh->triangles.size() > kManyTriangles)) break;
    }
    return best;
}

/// The mesh of a body; that of a solid whose faces share no edges is sewn first.
solid::Mesh meshed(const TopoDS_Shape& body, SettleMesh settle, const std::filesystem::path& path) {
    Attempt best = tessellated(body, settle);
    if (best.faults == std::numeric_limits<std::size_t>::max() && brep::count_solids(body) > 0) {
        const std::vector<TopoDS_Shape> shells = sewn(parts(body, TopAbs_FACE));
        if (shells.size() == 1)
            if (Attempt again = tessellated(shells.front(), settle); again.faults < best.faults) best = std::move(again);
    }
    if (!best.mesh) throw core::IoError(path.string(), "OpenCASCADE cannot tessellate one of its faces");
    return std::move(*best.mesh);
}

/// @param placement of the body; one that mirrors turns its triangles over
void append(solid::Mesh& all, const solid::Mesh& more, const gp_Trsf& placement) {
    const auto first = static_cast<std::uint32_t>(all.points_mm.size());
    for (const solid::Vec3& p : more.points_mm) {
        const gp_Pnt at = gp_Pnt(p[0], p[1], p[2]).Transformed(placement);
        all.points_mm.push_back({at.X(), at.Y(), at.Z()});
    }
    const bool turned = placement.VectorialPart().Determinant() < 0.0;
    for (const solid::Triangle& t : more.triangles)
        all.triangles.push_back({first + t[0], first + t[turned ? 2 : 1], first + t[turned ? 1 : 2]});
}

/// "millimetre", or all units of a file with several.
std::string units_of(STEPControl_Reader& reader) {
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    std::string all;
    std::set<std::string> told;
    for (const TCollection_AsciiString& unit : lengths)
        if (told.insert(unit.ToCString()).second) all += (all.empty() ? "" : ", ") + std::string(unit.ToCString());
    return all.empty() ? "millimetre" : all;
}

}  // namespace

MeshFile read_step_mesh(const std::filesystem::path& path, const std::string& bytes, SettleMesh settle) {
    MeshFile file;
    with_step_shape(path, bytes, [&](const TopoDS_Shape& shape, STEPControl_Reader& reader) {
        file.unit = units_of(reader) + " (STEP)";
        std::map<std::pair<const TopoDS_TShape*, TopAbs_Orientation>, solid::Mesh> known;  // one mesh for all places of a part
        const std::vector<TopoDS_Shape> bodies = bodies_of(shape);
        for (const TopoDS_Shape& body : bodies) {
            const auto [found, fresh] = known.try_emplace({body.TShape().get(), body.Orientation()});
            if (fresh) found->second = meshed(body.Located(TopLoc_Location()), settle, path);
            append(file.mesh, found->second, body.Location().Transformation());
        }
    });
    return file;
}

}  // namespace fusee::exchange
