#include "fusee/core/error.h"
#include "fusee/exchange/scad.h"
#include "fusee/exchange/stl.h"
#include "fusee/formats/format.h"
#include "fusee/solid/mesh_faults.h"
#include "fusee/solid/validity.h"

namespace fs = std::filesystem;

namespace fusee::formats {

solid::Mesh rendered_by_openscad(const PartExport& out) {
    const fs::path scad = out.path("_openscad.scad"), stl = out.path("_openscad.stl");
    exchange::write_scad(scad, out.part, out.provenance.line());
    exchange::render_scad(scad, stl);
    const solid::Mesh raw = exchange::read_stl_openmesh(stl);
    fs::remove(scad);
    fs::remove(stl);
    solid::Mesh mesh = solid::without_slivers(raw).value_or(raw);
    if (const solid::Validity validity = solid::validate(mesh); !validity.good())
        throw core::IoError(scad.filename().string(), "OpenSCAD's solid is not valid: " + validity.line());
    return mesh;
}

}  // namespace fusee::formats
