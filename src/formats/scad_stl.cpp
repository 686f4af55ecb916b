#include "fusee/exchange/stl.h"
#include "fusee/formats/format.h"

namespace fusee::formats {

Format make_scad_stl() {
    return {.name = "scad_stl",
            .extension = ".stl",
            .meaning = "the SCAD file as OpenSCAD renders it",
            .note = kOpenScadRenders,
            .place = 4,
            .write = [](PartExport& out) {
                const std::filesystem::path stl = out.path("_openscad.stl");
                const solid::Mesh mesh = rendered_by_openscad(out);
                exchange::write_stl(stl, mesh, out.provenance.line());
                out.state(stl, mesh.triangles.size(), out.part.chordal_error_mm);
            }};
}

}  // namespace fusee::formats
