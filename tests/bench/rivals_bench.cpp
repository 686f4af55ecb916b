// K_SE (0) and K_PE (1) of pnrvsa by other means, in one run with fusee's own: BM_OpenScad is in make_bench.cpp.
//   cmake -S . -B build-bench -G Ninja -DFUSEE_BUILD_BENCH=ON && cmake --build build-bench --target run_bench_rivals
// BM_CutFusee, BM_CutCorefinement, BM_CutNef: the anchor hole from the same body, by fusee's Boolean near the tool, by CGAL's corefinement
// of whole meshes, and by Nef polyhedra of an exact kernel, as a first program would use CGAL. BM_BodyFusee, BM_ExactFusee and
// BM_PipeShell: the body with groove, bore and anchor hole; the last as one would draw it in a CAD kernel: an extruded blank less a groove
// swept by BRepOffsetAPI_MakePipeShell, less the holes, meshed by BRepMesh. Counters: volume in mm^3 (0: the program failed), triangles.
// BM_CrossingFusee, BM_CrossingCgal: all pairs of triangles that intersect, of K_PE with 740,000; CGAL's without the time of its
// half-edges.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax2.hxx>
#undef Handle  // CGAL has classes of this name

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <benchmark/benchmark.h>

#include "bench_design.h"
#include "bench_mesh.h"
#include "fusee/core/units.h"
#include "fusee/exchange/brep.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/mesh_faults.h"

using namespace fusee;

namespace {

void count(benchmark::State& state, double volume_mm3, std::size_t triangles) {
    state.counters["volume"] = volume_mm3;
    state.counters["triangles"] = static_cast<double>(triangles);
}

/// The part's body before its cuts, and the tool of the anchor hole.
struct Cut {
    solid::Mesh body, tool;
};
Cut anchor_cut(std::int64_t number) {
    const solid::Part& part = bench::part(number);
    solid::PartOptions options = part.options;
    options.features = {};
    options.features.anchor_hole_diameter = options.features.mark_width = 0.0;
    return {solid::build_part(part.cam, options).value().mesh, solid::make_cutters(part).front().mesh(0.5 * part.chordal_error_mm)};
}

template <class Kernel>
CGAL::Surface_mesh<typename Kernel::Point_3> surface(const solid::Mesh& mesh) {
    CGAL::Surface_mesh<typename Kernel::Point_3> out;
    std::vector<typename CGAL::Surface_mesh<typename Kernel::Point_3>::Vertex_index> vertices;
    for (const solid::Vec3& p : mesh.points_mm) vertices.push_back(out.add_vertex({p[0], p[1], p[2]}));
    for (const solid::Triangle& t : mesh.triangles) out.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    return out;
}

void BM_CutFusee(benchmark::State& state) {
    const Cut cut = anchor_cut(state.range(0));
    std::optional<solid::Mesh> left;
    for (auto _ : state) left = solid::cut(cut.body, {cut.tool});
    count(state, left ? solid::volume_mm3(*left) : 0.0, left ? left->triangles.size() : 0);
}

void BM_CutCorefinement(benchmark::State& state) {
    using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
    const Cut cut = anchor_cut(state.range(0));
    for (auto _ : state) {
        auto body = surface<Kernel>(cut.body), tool = surface<Kernel>(cut.tool);
        CGAL::Surface_mesh<Kernel::Point_3> left;
        const bool done = CGAL::Polygon_mesh_processing::corefine_and_compute_difference(body, tool, left);
        count(state, done ? CGAL::to_double(CGAL::Polygon_mesh_processing::volume(left)) : 0.0, left.number_of_faces());
    }
}

void BM_CutNef(benchmark::State& state) {
    using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
    const Cut cut = anchor_cut(state.range(0));
    for (auto _ : state) {
        auto body = surface<Kernel>(cut.body), tool = surface<Kernel>(cut.tool);
        const CGAL::Nef_polyhedron_3<Kernel> left = CGAL::Nef_polyhedron_3<Kernel>(body) - CGAL::Nef_polyhedron_3<Kernel>(tool);
        CGAL::Surface_mesh<Kernel::Point_3> mesh;
        CGAL::convert_nef_polyhedron_to_polygon_mesh(left, mesh, true);
        count(state, CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh)), mesh.number_of_faces());
    }
}

void BM_BodyFusee(benchmark::State& state) {
    const solid::Part& part = bench::part(state.range(0));
    solid::PartOptions options = part.options;
    options.features.leg_slot_width = options.features.mark_width = 0.0;
    solid::Mesh mesh;
    for (auto _ : state) mesh = solid::build_part(part.cam, options).value().mesh;
    count(state, solid::volume_mm3(mesh), mesh.triangles.size());
}

void BM_ExactFusee(benchmark::State& state) {
    const solid::Part& whole = bench::part(state.range(0));
    solid::PartOptions options = whole.options;
    options.features.leg_slot_width = options.features.mark_width = 0.0;
    const solid::Part part = solid::build_part(whole.cam, options).value();
    for (auto _ : state) count(state, exchange::brep::build(part).value().volume_mm3, 0);
}

/// A closed spline through the pitch curve's parallel at `offset_mm`.
TopoDS_Wire parallel(const solid::Part& part, double offset_mm) {
    constexpr int kPoints = 200;
    const opencascade::handle<TColgp_HArray1OfPnt> points = new TColgp_HArray1OfPnt(1, kPoints);
    for (int i = 0; i < kPoints; ++i) {
        const double psi = part.cam.groove_psi.low + 2.0 * core::kPi * i / kPoints;
        const solid::Point2 p = solid::flange_point(part.cam.path(psi), offset_mm, 0.0).point;
        points->SetValue(i + 1, gp_Pnt(p[0], p[1], 0.0));
    }
    GeomAPI_Interpolate through(points, true, 1e-9);
    through.Perform();
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(through.Curve()).Edge()).Wire();
}

TopoDS_Shape raised(const TopoDS_Wire& outline, double low_mm, double high_mm) {
    gp_Trsf down;
    down.SetTranslation(gp_Vec(0.0, 0.0, low_mm));
    const TopoDS_Face base = BRepBuilderAPI_MakeFace(TopoDS::Wire(outline.Moved(TopLoc_Location(down)))).Face();
    return BRepPrimAPI_MakePrism(base, gp_Vec(0.0, 0.0, high_mm - low_mm)).Shape();
}

/// The groove as a solid: its section, closed beyond the lips, along the pitch curve.
TopoDS_Shape swept_groove(const solid::Part& part) {
    constexpr double kBeyond_mm = 0.5;
    const double psi = part.cam.groove_psi.low;
    const cam::PathPoint path = part.cam.path(psi);
    const auto at = [&](double offset_mm, double z_mm) {
        const solid::Point2 p = solid::flange_point(path, offset_mm, 0.0).point;
        return gp_Pnt(p[0], p[1], z_mm);
    };
    BRepBuilderAPI_MakePolygon section;
    for (const solid::SectionPoint& s : part.section) section.Add(at(s.offset_mm, s.z_mm));
    section.Add(at(part.section.back().offset_mm + kBeyond_mm, part.section.back().z_mm));
    section.Add(at(part.section.front().offset_mm + kBeyond_mm, part.section.front().z_mm));
    section.Close();
    BRepOffsetAPI_MakePipeShell sweep(parallel(part, 0.0));
    sweep.SetMode(gp_Dir(0.0, 0.0, 1.0));
    sweep.Add(section.Wire());
    sweep.Build();
    sweep.MakeSolid();
    return sweep.Shape();
}

TopoDS_Shape hole(double x_mm, double y_mm, double radius_mm, double low_mm, double high_mm) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x_mm, y_mm, low_mm), gp_Dir(0.0, 0.0, 1.0)), radius_mm, high_mm - low_mm).Shape();
}

TopoDS_Shape drawn_body(const solid::Part& part) {
    const double low = core::mm_from_m(part.z_low), high = core::mm_from_m(part.z_high);
    TopTools_ListOfShape blank, tools;
    blank.Append(raised(parallel(part, part.section.back().offset_mm), low, high));
    tools.Append(swept_groove(part));
    const solid::HubOptions& hub = part.options.hub;
    tools.Append(hole(0.0, 0.0, core::mm_from_m(0.5 * (hub.bore_diameter + hub.bore_clearance)), low - 1.0, high + 1.0));
    const solid::Cutter anchor = solid::make_cutters(part).front();
    tools.Append(
        hole(anchor.outline[0].centre_mm[0], anchor.outline[0].centre_mm[1], anchor.outline[0].radius_mm, anchor.low_mm, anchor.high_mm));
    BRepAlgoAPI_Cut cut;
    cut.SetArguments(blank);
    cut.SetTools(tools);
    cut.Build();
    return cut.Shape();
}

std::size_t triangles_of(const TopoDS_Shape& shape) {
    std::size_t triangles = 0;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        TopLoc_Location place;
        const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(face.Current()), place);
        if (!mesh.IsNull()) triangles += static_cast<std::size_t>(mesh->NbTriangles());
    }
    return triangles;
}

void BM_PipeShell(benchmark::State& state) {
    const solid::Part& part = bench::part(state.range(0));
    for (auto _ : state) try {
            const TopoDS_Shape shape = drawn_body(part);
            const BRepMesh_IncrementalMesh mesh(shape, part.chordal_error_mm, false, 0.12);
            state.PauseTiming();
            GProp_GProps properties;
            BRepGProp::VolumeProperties(shape, properties, 1e-4);
            count(state, properties.Mass(), triangles_of(shape));
            state.counters["valid"] = BRepCheck_Analyzer(shape).IsValid() ? 1.0 : 0.0;
            state.ResumeTiming();
        } catch (const Standard_Failure& failure) {
            return state.SkipWithError(failure.GetMessageString());
        }
}

/// A waved torus with a million triangles (0), and K_PE with 153,000 (1).
const solid::Mesh& fine(std::int64_t number) {
    static const solid::Mesh torus = bench::waved_torus(707);
    static const solid::Mesh part = [] {
        solid::PartOptions options = bench::part(1).options;
        options.chordal_error = 100e-9;
        return solid::build_part(bench::cam(1), options).value().mesh;
    }();
    return number == 0 ? torus : part;
}

void BM_CrossingFusee(benchmark::State& state) {
    const solid::Mesh& mesh = fine(state.range(0));
    for (auto _ : state) benchmark::DoNotOptimize(solid::crossings(mesh, {}, solid::kMostNearPairs, true));
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

void BM_CrossingCgal(benchmark::State& state) {
    const solid::Mesh& mesh = fine(state.range(0));
    const auto halfedges = surface<CGAL::Exact_predicates_inexact_constructions_kernel>(mesh);
    for (auto _ : state) {
        std::vector<std::pair<CGAL::SM_Face_index, CGAL::SM_Face_index>> pairs;
        CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(halfedges, std::back_inserter(pairs));
        benchmark::DoNotOptimize(pairs);
    }
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

#define RIVAL(name) BENCHMARK(name)->Arg(0)->Arg(1)->ArgName("k_pe")->Unit(benchmark::kMillisecond)
RIVAL(BM_CutFusee);
RIVAL(BM_CutCorefinement);
RIVAL(BM_CutNef)->Iterations(1);
RIVAL(BM_BodyFusee);
RIVAL(BM_ExactFusee);
RIVAL(BM_PipeShell)->Iterations(1);
BENCHMARK(BM_CrossingFusee)->Arg(0)->Arg(1)->ArgName("k_pe")->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CrossingCgal)->Arg(0)->Arg(1)->ArgName("k_pe")->Unit(benchmark::kMillisecond);

}  // namespace
