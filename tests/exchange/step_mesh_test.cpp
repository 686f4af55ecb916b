#include <fmt/format.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Trsf.hxx>
#include <map>
#include <numbers>

#include "brep/kernel/measure.h"
#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/file.h"
#include "fusee/exchange/mesh_file.h"
#include "fusee/inspect/topology.h"
#include "fusee/solid/mesh_faults.h"

// STEP of any shape that OpenCASCADE calls valid comes in as a sound mesh of as many parts as the file has.
namespace fusee::exchange {
namespace {

using Shape = TopoDS_Shape;

gp_Ax2 axis(double x, double y, double z, const gp_Dir& along = gp_Dir(0, 0, 1)) { return {gp_Pnt(x, y, z), along}; }
Shape box(double x, double y, double z, double a, double b, double c) { return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), a, b, c).Shape(); }
Shape cylinder(const gp_Ax2& at, double radius, double height) { return BRepPrimAPI_MakeCylinder(at, radius, height).Shape(); }
Shape cut(const Shape& a, const Shape& b) { return BRepAlgoAPI_Cut(a, b).Shape(); }
Shape fuse(const Shape& a, const Shape& b) { return BRepAlgoAPI_Fuse(a, b).Shape(); }
Shape rounded(const Shape& shape, double radius) {
    BRepFilletAPI_MakeFillet fillet(shape);
    for (TopExp_Explorer edge(shape, TopAbs_EDGE); edge.More(); edge.Next()) fillet.Add(radius, TopoDS::Edge(edge.Current()));
    return fillet.Shape();
}
Shape revolved(const std::vector<gp_Pnt>& outline, double angle) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const gp_Pnt& p : outline) polygon.Add(p);
    polygon.Close();
    return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(polygon.Wire()).Face(), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), angle).Shape();
}
TopoDS_Wire circle(double z, double radius) {
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axis(0, 0, z), radius)).Edge()).Wire();
}
Shape lofted(bool to_a_point) {
    BRepOffsetAPI_ThruSections loft(true, false, 1e-6);
    loft.AddWire(circle(0, 5));
    loft.AddWire(circle(8, 3));
    if (to_a_point)
        loft.AddVertex(BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, 15)).Vertex());
    else
        loft.AddWire(circle(20, 6));
    loft.Build();
    return loft.Shape();
}
Shape compound(std::initializer_list<Shape> shapes) {
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (const Shape& shape : shapes) builder.Add(all, shape);
    return all;
}
Shape turned(const Shape& shape, double angle) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), angle);
    return BRepBuilderAPI_Transform(shape, turn, true).Shape();
}
Shape mirrored(const Shape& shape) {
    gp_Trsf mirror;
    mirror.SetMirror(axis(-20, 0, 0, gp_Dir(1, 0, 0)));
    return BRepBuilderAPI_Transform(shape, mirror, true).Shape();
}
/// The same part at three places, as an assembly has it.
Shape instances() {
    const Shape part = rounded(fuse(box(0, 0, 0, 10, 10, 10), cylinder(axis(5, 5, 5), 2, 10)), 0.5);
    gp_Trsf place, turn;
    place.SetTranslation(gp_Vec(50, 0, 0));
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 40), gp_Dir(1, 1, 1)), 1.0);
    return compound({part, part.Moved(place), part.Moved(turn)});
}
/// Faces that share no edges.
Shape loose_faces() {
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (TopExp_Explorer face(rounded(box(0, 0, 0, 10, 10, 10), 1), TopAbs_FACE); face.More(); face.Next())
        builder.Add(all, BRepBuilderAPI_Copy(face.Current()).Shape());
    return all;
}
Shape wedge(double width, double height) {
    BRepBuilderAPI_MakePolygon outline(gp_Pnt(0, 0, 0), gp_Pnt(width, 0, 0), gp_Pnt(width, height, 0), true);
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 10)).Shape();
}

struct Kind {
    const char* name;
    Shape (*make)();
    std::size_t parts = 1;
    const char* unit = "MM";
    double mm = 1.0;  ///< of the unit
};
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

class StepMeshFile : public fixtures::FolderTest {
protected:
    std::filesystem::path write(const Shape& shape, const char* unit = "MM") const {
        STEPControl_Writer writer;
        Interface_Static::SetCVal("write.step.unit", unit);
        writer.Transfer(shape, STEPControl_AsIs);
        writer.Write((folder_ / "a.step").c_str());
        Interface_Static::SetCVal("write.step.unit", "MM");
        return folder_ / "a.step";
    }
};
class StepMesh : public StepMeshFile, public testing::WithParamInterface<Kind> {};

TEST_P(StepMesh, IsSound) {
    const Shape shape = GetParam().make();
    const MeshFile file = read_mesh_file(write(shape, GetParam().unit));
    const inspect::Topology topology = inspect::topology_of(file.mesh);
    EXPECT_EQ(topology.open_edges, 0u);
    EXPECT_EQ(topology.crowded_edges, 0u);
    EXPECT_EQ(topology.flipped_edges, 0u);
    EXPECT_EQ(topology.pinched_points, 0u);
    EXPECT_EQ(topology.components.size(), GetParam().parts);
    const auto flat = inspect::flat_triangles(file.mesh);
    EXPECT_EQ(flat.size(), 0u);
    const solid::Crossings crossings = solid::crossings(file.mesh, flat);
    EXPECT_TRUE(crossings.manifold);
    EXPECT_TRUE(crossings.pairs.empty());
    double volume = std::abs(brep::volume_mm3(shape)) * std::pow(GetParam().mm, 3);
    if (brep::count_solids(shape) == 0) volume = 1000.0;  // the loose faces: a cube of 10 mm with its edges rounded
    EXPECT_NEAR(solid::volume_mm3(file.mesh), volume, 0.03 * volume);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, StepMesh,
    testing::Values(
        Kind{"sphere", [] { return Shape(BRepPrimAPI_MakeSphere(10).Shape()); }},
        Kind{"sphere_segment", [] { return Shape(BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 0), 10, -0.3, std::numbers::pi / 2, 2.0).Shape()); }},
        Kind{"cone", [] { return Shape(BRepPrimAPI_MakeCone(10, 0, 20).Shape()); }},
        Kind{"cone_segment", [] { return Shape(BRepPrimAPI_MakeCone(10, 0, 20, 1.0).Shape()); }},
        Kind{"cone_halved", [] { return cut(BRepPrimAPI_MakeCone(10, 0, 20).Shape(), box(0, -20, -1, 20, 40, 30)); }},
        Kind{"torus", [] { return Shape(BRepPrimAPI_MakeTorus(20, 5).Shape()); }},
        Kind{"torus_without_hole", [] { return Shape(BRepPrimAPI_MakeTorus(5, 5).Shape()); }},
        Kind{"seam_cut_through", [] { return cut(cylinder(axis(0, 0, 0), 10, 20), cylinder(axis(0, 0, 10, gp_Dir(1, 0, 0)), 3, 30)); }},
        Kind{"seam_slot", [] { return cut(cylinder(axis(0, 0, 0), 10, 20), box(5, -1e-3, 5, 10, 2e-3, 5)); }},
        Kind{"fillets", [] { return rounded(cut(box(0, 0, 0, 40, 40, 15), box(5, 5, 5, 30, 30, 20)), 1.5); }},
        Kind{"fillet_of_fillets", [] { return rounded(fuse(rounded(box(0, 0, 0, 20, 10, 10), 2), cylinder(axis(10, 5, 5), 2, 20)), 0.5); }},
        Kind{"loft", [] { return lofted(false); }}, Kind{"loft_to_a_point", [] { return lofted(true); }},
        Kind{"revolved_on_its_axis",
             [] {
                 return revolved({gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0), gp_Pnt(6, 0, 5), gp_Pnt(0, 0, 12)}, 2 * std::numbers::pi);
             }},
        Kind{"revolved_in_part",
             [] {
                 return revolved({gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0), gp_Pnt(6, 0, 5), gp_Pnt(0, 0, 12)}, 4.0);
             }},
        Kind{"touches_itself_in_a_point",
             [] {
                 return revolved({gp_Pnt(0, 0, 0), gp_Pnt(10, 0, -3), gp_Pnt(10, 0, 5)}, 2 * std::numbers::pi);
             }},
        Kind{"touches_itself_in_an_edge",
             [] { return cut(box(0, 0, 0, 30, 30, 10), fuse(box(5, 5, -1, 10, 10, 20), box(15, 15, -1, 10, 10, 20))); }},
        Kind{"holes_touch",
             [] { return cut(cut(box(0, 0, 0, 40, 20, 4), cylinder(axis(10, 10, -1), 5, 10)), cylinder(axis(20, 10, -1), 5, 10)); }},
        Kind{"ring_tangent_inside", [] { return cut(cylinder(axis(0, 0, 0), 10, 5), cylinder(axis(4, 0, -1), 6, 10)); }},
        Kind{"thin_plate", [] { return box(0, 0, 0, 100, 10, 1e-3); }}, Kind{"sliver", [] { return wedge(100, 0.002); }},
        Kind{"thin_ring", [] { return cut(cylinder(axis(0, 0, 0), 10, 5), turned(cylinder(axis(0, 0, -1), 9.995, 10), 0.05)); }},
        Kind{"tiny_step", [] { return fuse(cylinder(axis(0, 0, 0), 10, 10), cylinder(axis(0, 0, 10), 10.00005, 5)); }},
        Kind{"cavity", [] { return cut(BRepPrimAPI_MakeSphere(10).Shape(), BRepPrimAPI_MakeSphere(5).Shape()); }, 2},
        Kind{"two_that_touch",
             [] {
                 return compound({box(0, 0, 0, 10, 10, 10), box(10, 10, 0, 10, 10, 10)});
             },
             2},
        Kind{"instances", instances, 3}, Kind{"mirrored", [] { return mirrored(rounded(box(0, 0, 0, 10, 20, 10), 1)); }},
        Kind{"loose_faces", loose_faces}, Kind{"inch", [] { return rounded(box(0, 0, 0, 1, 0.5, 0.4), 0.1); }, 1, "INCH", 25.4},
        Kind{"metre", [] { return rounded(box(0, 0, 0, 0.0254, 0.0127, 0.01), 0.002); }, 1, "M", 1000.0}),
    [](const auto& kind) { return std::string(kind.param.name); });

TEST_F(StepMeshFile, NamesTheUnitOfTheFile) {
    EXPECT_EQ(read_mesh_file(write(box(0, 0, 0, 25.4, 10, 10), "INCH")).unit, "INCH (STEP)");
    EXPECT_EQ(read_mesh_file(write(box(0, 0, 0, 25.4, 10, 10))).unit, "millimetre (STEP)");
}

TEST_F(StepMeshFile, AFaceAloneStaysOpen) {
    const MeshFile file = read_mesh_file(write(BRepBuilderAPI_MakeFace(circle(0, 5)).Face()));
    EXPECT_GT(inspect::topology_of(file.mesh).open_edges, 0u);
}

/// The chords of a part of 20 m are not 0.01 mm from it.
TEST_F(StepMeshFile, AHugePartHasFewTriangles) {
    EXPECT_LT(read_mesh_file(write(rounded(box(0, 0, 0, 20'000, 10'000, 10'000), 2'000))).mesh.triangles.size(), 100'000u);
}

/// The box as a mapped item, placed by this operator. @param z its third axis
std::string mapped(std::string step, const std::string& z, double scale) {
    const std::string root = "ADVANCED_BREP_SHAPE_REPRESENTATION('',(#11,#15),#";
    const std::size_t at = step.find(root), context = at + root.size();
    EXPECT_NE(at, std::string::npos) << step.substr(0, 2000);
    const std::string number = step.substr(context, step.find(')', context) - context);
    const std::string definition = "SHAPE_DEFINITION_REPRESENTATION(#4,#10)";
    step.replace(step.find(definition), definition.size(), "SHAPE_DEFINITION_REPRESENTATION(#4,#90008)");
    return step.insert(step.rfind("ENDSEC;"),
                       "#90001=REPRESENTATION_MAP(#11,#10);\n#90002=CARTESIAN_POINT('',(-30.,0.,0.));\n"
                       "#90003=DIRECTION('',(1.,0.,0.));\n#90004=DIRECTION('',(0.,1.,0.));\n#90005=DIRECTION('',(" +
                           z + "));\n#90006=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',#90003,#90004,#90002," +
                           fmt::format("{:.1f}", scale) +
                           ",#90005);\n#90007=MAPPED_ITEM('',#90001,#90006);\n"
                           "#90008=SHAPE_REPRESENTATION('',(#11,#90007),#" +
                           number + ");\n");
}

TEST_F(StepMeshFile, APlacementThatMirrorsOrScalesIsRefused) {
    const std::string step = core::read_file(write(box(0, 0, 0, 10, 20, 30)));
    const auto read = [&](const std::string& z, double scale) {
        core::write_file(folder_ / "b.step", mapped(step, z, scale));
        return read_mesh_file(folder_ / "b.step").mesh;
    };
    EXPECT_NEAR(solid::bounding_box(read("0.,0.,1.", 1.0)).low_mm[0], -30.0, 1e-6);
    fixtures::expect_refusal([&] { (void)read("0.,0.,-1.", 1.0); }, {"b.step", "#90006", "mirror image"});
    fixtures::expect_refusal([&] { (void)read("0.,0.,1.", 2.0); }, {"b.step", "#90006", "with a scale"});
}

TEST_F(StepMeshFile, OthersCad) {
    const std::filesystem::path folder = std::filesystem::path(FUSEE_SOURCE_DIR) / "../shared/cases/mesh_step";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
    std::map<std::string, std::size_t> parts;
    for (const char* name : {"pulley.step", "motor_holder.step", "motor_holder.stl"}) {
        const inspect::Topology topology = inspect::topology_of(read_mesh_file(folder / name).mesh);
        EXPECT_EQ(topology.open_edges + topology.crowded_edges + topology.flipped_edges + topology.pinched_points, 0u) << name;
        parts[name] = topology.components.size();
    }
    EXPECT_EQ(parts["motor_holder.step"], parts["motor_holder.stl"]);
}

}  // namespace
}  // namespace fusee::exchange
