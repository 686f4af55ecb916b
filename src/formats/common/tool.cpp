#include "common/tool.h"

#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/exchange/scad.h"
#include "fusee/exchange/stl.h"
#include "fusee/formats/format.h"
#include "fusee/solid/mesh_faults.h"
#include "fusee/solid/validity.h"

namespace fusee::formats {

core::Finding done_by(const Tool& tool, const solid::Part& part) {
    core::Finding f;
    f.rule = tool.rule;
    f.what = tool.what;
    f.measured = tool.there ? 1.0 : 0.0;
    f.bound = core::Bound::kAtLeast;
    f.allowed = 1.0;
    f.where = to_string(part.cam.kind);
    f.suggestion = fmt::format("install the package {} and make again: {}", tool.package, tool.undone);
    f.source = tool.source;
    return core::judged(f, core::Severity::kWarning);
}

const std::vector<drawing::Sheet>& sheets_of(PartExport& out) {
    if (!out.sheets) out.sheets = drawing::draw(subject_of(out));
    return *out.sheets;
}

drawing::Subject subject_of(const PartExport& out) {
    const Settings& settings = out.settings;
    return {out.part, out.spring, settings.cable, settings.process, settings.design, out.name(), out.provenance.line(), settings.title};
}

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
