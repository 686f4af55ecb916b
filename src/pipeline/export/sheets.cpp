#include "fusee/core/file.h"
#include "fusee/drawing/drawing.h"
#include "fusee/drawing/svg.h"
#include "part_export.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

void write_sheets(PartExport& out) {
    const profile::Outputs& outputs = out.profile.outputs;
    if (!outputs.drawing && !outputs.pdf) return;
    const std::vector<drawing::Sheet> sheets =
        drawing::draw({out.part, out.spring, out.profile.cable, out.profile.process, out.profile.name, out.name(), out.provenance.line()});
    std::vector<fs::path> written;
    if (outputs.drawing) written = drawing::write_svg(out.path("_drawing"), sheets);
    if (outputs.pdf) {
        written.push_back(out.path("_drawing.pdf"));
        core::write_file(written.back(), drawing::pdf(sheets));
    }
    for (const fs::path& file : written) out.other_files.push_back(file_row(file, 0, out.part.chordal_error_mm));
}

}  // namespace fusee::pipeline
