#include "common/tool.h"
#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "fusee/exchange/prusa_slicer.h"
#include "fusee/exchange/stl.h"
#include "fusee/formats/format.h"
#include "fusee/readback/readback.h"

namespace fusee::formats {

namespace {

void write_sliced(PartExport& out) {
    const bool there = exchange::can_slice();
    out.findings.push_back(done_by({"readback.slicer", "the part is sliced by PrusaSlicer and the arm recomputed from its perimeters",
                                    there, "prusa-slicer", "the part has not been sliced", "docs/theory/read_back.md"},
                                   out.part));
    if (!there) return;
    const double layer_mm = core::mm_from_m(checks::process_limits(out.settings.process).layer);
    const fs::path stl = out.path("_to_slice.stl"), gcode = out.path(".gcode");
    const std::string provenance = out.provenance.line();
    exchange::write_stl(stl, out.mesh, provenance);
    exchange::slice_stl(stl, gcode, {.layer_mm = layer_mm, .lowest_mm = solid::bounding_box(out.mesh).low_mm[2]}, provenance);
    fs::remove(stl);
    out.state(gcode, 0, layer_mm);
}

}  // namespace

Format make_sliced() {
    return {.name = "sliced",
            .extension = ".gcode",
            .meaning = "PrusaSlicer's G-code, fdm only",
            .note = "PrusaSlicer slices the parts",
            .place = 5,
            .write = write_sliced,
            .read_back = readback::read_print};
}

}  // namespace fusee::formats
