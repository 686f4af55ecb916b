#include <fmt/format.h>

#include "fusee/core/units.h"
#include "fusee/exchange/dxf.h"
#include "fusee/formats/format.h"

namespace fusee::formats {

namespace {

/// Plates are flat and cut through: a helix is not, and a boss is no plate of the groove's outline.
core::Finding not_flat(const solid::Part& part) {
    const double boss = part.options.hub.boss_height;
    core::Finding f = core::error_finding("stack.boss", "height of the boss below the plates: no plates were drawn", core::mm_from_m(boss),
                                          core::Bound::kAtMost, 0.0, "mm");
    f.where = to_string(part.cam.kind);
    f.suggestion = core::change(f.where + ".hub.boss_height_mm", "0")
                       .with(f.where + ".hub.kind", core::quoted("through"))
                       .or_else("outputs.formats without \"plates\"");
    f.source = "geometry: plates are cut through";
    return core::judged(f, core::Severity::kWarning);
}

void write_plates(PartExport& out) {
    if (!out.part.cam.closed() || out.part.cam.has_roller()) return;
    if (out.part.options.hub.boss_height > 0.0) return out.findings.push_back(not_flat(out.part));
    const auto write = [&](const std::vector<exchange::DxfDrawing>& drawings, const char* ending, std::vector<FileRow>& rows) {
        for (std::size_t i = 0; i < drawings.size(); ++i) {
            const std::filesystem::path dxf = out.path(fmt::format("_plate_{}{}.dxf", i + 1, ending));
            exchange::write_dxf(dxf, drawings[i]);
            rows.push_back(file_row(dxf, 0, exchange::kDrawingChord_mm));
        }
    };
    write(exchange::stack_drawings(out.part, out.provenance.line()), "", out.law_files);
    if (const double kerf = core::mm_from_m(out.settings.kerf); kerf > 0.0)
        write(exchange::stack_kerf_drawings(out.part, kerf, out.provenance.line()), "_kerf", out.other_files);
}

}  // namespace

Format make_plates() {
    return {.name = "plates",
            .extension = ".dxf",  // read back as dxf is
            .meaning = "a DXF for each plate of a stack, by default for edm and laser",
            .place = 7,
            .by_default = checks::is_stacked,
            .write = write_plates};
}

}  // namespace fusee::formats
