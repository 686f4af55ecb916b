#include "fusee/core/error.h"
#include "fusee/exchange/openscad.h"
#include "fusee/exchange/scad.h"
#include "fusee/exchange/stl.h"
#include "fusee/solid/slivers.h"
#include "fusee/solid/validity.h"
#include "part_export.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

solid::Mesh rendered(const fs::path& scad, const fs::path& stl) {
    exchange::render_scad(scad, stl);
    const solid::Mesh raw = exchange::read_stl_openmesh(stl);
    solid::Mesh mesh = solid::without_slivers(raw).value_or(raw);
    if (const solid::Validity validity = solid::validate(mesh); !validity.good())
        throw core::IoError(scad.filename().string(), "OpenSCAD's solid is not valid: " + validity.line());
    return mesh;
}

void write_rendered(PartExport& out) {
    if (!out.profile.outputs.scad_stl) return;
    const fs::path scad = out.path("_openscad.scad"), stl = out.path("_openscad.stl");
    const std::string provenance = out.provenance.line();
    exchange::write_scad(scad, out.part, provenance);
    const solid::Mesh mesh = rendered(scad, stl);
    fs::remove(scad);
    exchange::write_stl(stl, mesh, provenance);
    out.state(stl, mesh.triangles.size(), out.part.chordal_error_mm);
}

}  // namespace fusee::pipeline
