#include "fusee/exchange/dxf.h"

#include "fusee/core/units.h"
#include "fusee/formats/format.h"
#include "fusee/readback/readback.h"

namespace fusee::formats {

namespace {

void write_outlines(PartExport& out) {
    if (!out.part.cam.closed()) return;
    const std::string provenance = out.provenance.line();
    const std::filesystem::path dxf = out.path(".dxf"), moved = out.path("_kerf.dxf");
    exchange::write_dxf(dxf, exchange::spool_drawing(out.part, provenance));
    out.state(dxf, 0, exchange::kDrawingChord_mm);
    if (out.settings.kerf <= 0.0) return;
    exchange::write_dxf(moved, exchange::kerf_drawing(out.part, core::mm_from_m(out.settings.kerf), provenance));
    out.other_files.push_back(file_row(moved, 0, exchange::kDrawingChord_mm));
}

}  // namespace

Format make_dxf() {
    return {.name = "dxf",
            .extension = ".dxf",
            .meaning = "the outlines of a planar part",
            .place = 6,
            .by_default = always,
            .write = write_outlines,
            .read_back = readback::read_drawing};
}

}  // namespace fusee::formats
