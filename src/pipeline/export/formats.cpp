#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/exchange/scad.h"
#include "fusee/exchange/step.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "part_export.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

// With OpenSCAD the mesh comes from the SCAD file through an STL file; files that were not asked for are removed.
void write_meshes(PartExport& out) {
    const profile::Outputs& outputs = out.profile.outputs;
    const std::string provenance = out.provenance.line();
    const fs::path scad = out.path(".scad"), stl = out.path(".stl"), three_mf = out.path(".3mf");
    const bool missing = out.mesh.points_mm.empty(), rendering = missing && out.via == Via::kOpenScad;
    if (outputs.scad || rendering) exchange::write_scad(scad, out.part, provenance);
    if (missing) out.mesh = rendering ? rendered(scad, stl) : out.part.mesh;
    if (outputs.stl) exchange::write_stl(stl, out.mesh, provenance);
    if (outputs.three_mf) exchange::write_3mf(three_mf, out.mesh, out.name(), provenance);
    if (!outputs.scad) fs::remove(scad);
    if (!outputs.stl) fs::remove(stl);

    const std::size_t triangles = out.mesh.triangles.size();
    if (outputs.stl) out.state(stl, triangles, out.part.chordal_error_mm);
    if (outputs.three_mf) out.state(three_mf, triangles, out.part.chordal_error_mm);
    if (outputs.scad) out.state(scad, 0, out.part.chordal_error_mm);
}

void write_drawing(PartExport& out) {
    if (!out.profile.outputs.dxf || !out.part.cam.closed()) return;
    const fs::path dxf = out.path(".dxf");
    exchange::write_dxf(dxf, exchange::spool_drawing(out.part, out.provenance.line()));
    out.state(dxf, 0, exchange::kDrawingChord_mm);
}

void write_exact(PartExport& out) {
    if (!out.profile.outputs.step) return;
    if (!out.exact) {
        auto built = brep::build(out.part);
        if (!built) return core::append(out.findings, built.refusal());
        out.exact = std::move(built).value();
    }
    const fs::path step = out.path(".step");
    exchange::write_step(step, *out.exact, out.name(), out.provenance.line());
    out.state(step, 0, out.exact->deviation_mm);
}

void write_kerf(PartExport& out) {
    const double kerf = out.profile.outputs.kerf;
    if (!out.profile.outputs.dxf || kerf <= 0.0 || !out.part.cam.closed()) return;
    const fs::path dxf = out.path("_kerf.dxf");
    exchange::write_dxf(dxf, exchange::kerf_drawing(out.part, core::mm_from_m(kerf), out.provenance.line()));
    out.other_files.push_back(file_row(dxf, 0, exchange::kDrawingChord_mm));
}

}  // namespace fusee::pipeline
