#include <fmt/format.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepLib.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "failure.h"
#include "fusee/cam/mirror.h"
#include "fusee/core/units.h"
#include "fusee/exchange/brep.h"
#include "fusee/solid/part.h"
#include "measure.h"
#include "strip.h"

namespace fusee::exchange::brep {

namespace {

constexpr double kSewing_mm = 1e-3;             // edges of neighbouring faces are apart by at most twice their splines' deviation
constexpr double kVolume = 5e-4;                // allowed relative difference from the mesh's volume
constexpr double kGoodVolume = 2e-4;            // with two pieces, below which three are not evaluated: facets alone cause 1e-4
constexpr int kIdlePieces[] = {2, 3, 4, 5, 6};  // evaluated in turn: default integrals are more exact on more faces
constexpr std::size_t kMostFaces = 50;
constexpr double kFuzzy_mm[] = {0.0, 1e-5, 1e-4};        // in turn: OpenCASCADE's Booleans fail silently at some positions
constexpr double kShorterChords[] = {0.5, 0.25, 0.125};  // in turn, for a suggestion

TopoDS_Shape sewn_body(const Side& side, const solid::HubOptions& hub) {
    BRepBuilderAPI_Sewing sewing(kSewing_mm);
    for (const TopoDS_Face& face : side.faces) sewing.Add(face);
    for (const TopoDS_Shape& face : closing_faces(side, hub)) sewing.Add(face);
    sewing.Perform();
    TopExp_Explorer shell(sewing.SewedShape(), TopAbs_SHELL);
    if (!shell.More()) return {};
    TopoDS_Solid body = BRepBuilderAPI_MakeSolid(TopoDS::Shell(shell.Current())).Solid();
    BRepLib::OrientClosedSolid(body);
    return body;
}

TopoDS_Shape without(const TopoDS_Shape& body, const std::vector<solid::Cutter>& cutters, double fuzzy_mm) {
    if (cutters.empty()) return body;
    TopTools_ListOfShape from, tools;
    from.Append(body);
    for (const solid::Cutter& cutter : cutters) tools.Append(prism(cutter));
    BRepAlgoAPI_Cut cut;
    cut.SetArguments(from);
    cut.SetTools(tools);
    cut.SetFuzzyValue(fuzzy_mm);
    cut.SetRunParallel(false);
    cut.SetCheckInverted(false);  // the body has just been oriented, and prisms are
    cut.Build();
    return cut.IsDone() ? cut.Shape() : TopoDS_Shape();
}

double misfit(const Brep& solid, double expected_mm3) { return std::abs(solid.volume_mm3 / expected_mm3 - 1.0); }

/// The first valid solid with the expected volume, otherwise the last valid one; empty if OpenCASCADE finds none valid.
Brep closed_by(const Side& side, const solid::Part& part, double expected_mm3) {
    const TopoDS_Shape body = sewn_body(side, part.options.hub);
    const std::vector<solid::Cutter> cutters = solid::make_cutters(part);
    Brep solid;
    for (const double fuzzy_mm : kFuzzy_mm) {
        if (!is_one_solid(body)) break;
        const TopoDS_Shape shape = without(body, cutters, fuzzy_mm);
        if (!is_one_solid(shape)) continue;
        solid = {std::make_shared<TopoDS_Shape>(shape), count_faces(shape), volume_mm3(shape), side.deviation_mm};
        if (misfit(solid, expected_mm3) <= kVolume) break;
    }
    return solid;
}

core::Finding refusal(const solid::Part& part, std::string what, double measured, core::Bound bound, double allowed, const char* unit) {
    core::Finding f = core::error_finding("brep.validity", std::move(what), measured, bound, allowed, unit);
    f.where = to_string(part.cam.kind);
    f.source = "OpenCASCADE: one valid solid; docs/theory/cams.md";
    return f;
}

core::Finding no_solid(const solid::Part& part) {
    core::Finding f = refusal(part, "OpenCASCADE builds no valid solid of this part", 0.0, core::Bound::kAtLeast, 1.0, "solids");
    f.suggestion = "the anchor hole, the leg slot or the mark elsewhere, or outputs.formats without \"step\"";
    return f;
}

/// The exact body is fixed; a finer mesh approaches it.
core::Finding another_volume(const solid::Part& part, const Brep& exact) {
    core::Finding f = refusal(part, "the exact solid's volume by OpenCASCADE is not that of the mesh",
                              100.0 * misfit(exact, solid::volume_mm3(part.mesh)), core::Bound::kAtMost, 100.0 * kVolume, "%");
    for (const double share : kShorterChords) {
        solid::PartOptions options = part.options;
        options.chordal_error *= share;
        const auto finer = solid::build_part(part.cam, options);
        if (!finer || misfit(exact, solid::volume_mm3(finer->mesh)) > kVolume) continue;
        f.suggestion = core::change("tolerances.chordal_error_mm", core::number(core::mm_from_m(options.chordal_error), 3));
        return f;
    }
    f.suggestion = "outputs.formats without \"step\": finer meshes, down to an eighth of the chordal error, do not agree either";
    return f;
}

/// The division of the idle arcs with the volume nearest to the mesh's.
Brep nearest_by_volume(const solid::Part& part, double expected) {
    Brep best;
    for (const int idle_pieces : kIdlePieces) {
        Brep next = closed_by(side_of(part, idle_pieces), part, expected);
        if (idle_pieces > kIdlePieces[0] && next.faces > kMostFaces) break;
        if (misfit(next, expected) < misfit(best, expected)) best = std::move(next);
        if (misfit(best, expected) <= (idle_pieces == kIdlePieces[0] ? kGoodVolume : kVolume) || !part.cam.closed()) break;
    }
    return best;
}

/// Does the solid enclose its inside, not everything else?
bool is_finite(const TopoDS_Shape& solid) {
    BRepClass3d_SolidClassifier place(solid);
    place.PerformInfinitePoint(Precision::Confusion());
    return place.State() == TopAbs_OUT;
}

/// A reflection keeps the size of a volume: integrating it again would take longer than everything else here.
Brep reflected_solid(const Brep& solid) {
    gp_Trsf reflection;
    reflection.SetMirror(gp_Ax2(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 1.0, 0.0)));
    const TopoDS_Shape shape = BRepBuilderAPI_Transform(*solid.shape, reflection, true).Shape();
    const std::size_t faces = count_faces(shape);
    if (faces != solid.faces || !is_one_solid(shape) || !is_finite(shape)) return {};
    return {std::make_shared<TopoDS_Shape>(shape), faces, solid.volume_mm3, solid.deviation_mm};
}

}  // namespace

core::Outcome<Brep> build(const solid::Part& part) {
    if (cam::left_handed(part.cam)) {  // strips run from the low end of psi upwards
        const auto right = build(solid::mirrored(part));
        return right ? mirrored(*right) : right;
    }
    const double expected = solid::volume_mm3(part.mesh);
    Brep best;
    try {
        guard([&] { best = nearest_by_volume(part, expected); });
    } catch (const Failure& failure) {
        core::Finding f = no_solid(part);
        f.what += fmt::format(" ({})", failure.what());
        return f;
    }
    if (misfit(best, expected) <= kVolume) return best;
    return best.shape ? another_volume(part, best) : no_solid(part);
}

core::Outcome<Brep> mirrored(const Brep& solid) {
    Brep other;
    std::string what = "OpenCASCADE builds no valid solid for the mirror image";
    try {
        guard([&] { other = reflected_solid(solid); });
    } catch (const Failure& failure) {
        what += fmt::format(" ({})", failure.what());
    }
    if (other.shape) return other;
    core::Finding f = core::error_finding("brep.validity", what, 0.0, core::Bound::kAtLeast, 1.0, "solids");
    f.suggestion = core::change("outputs.pair", "false").or_else("outputs.formats without \"step\"");
    f.source = "OpenCASCADE: one valid solid; docs/theory/cams.md";
    return f;
}

}  // namespace fusee::exchange::brep
