#include "fusee/drawing/drawing.h"

#include "common/tool.h"
#include "fusee/core/file.h"
#include "fusee/formats/format.h"

namespace fusee::formats {

namespace {

/// The drawing, and the sheet for the part's inspection.
void write_drawing(PartExport& out) {
    for (const std::filesystem::path& file : drawing::write_svg(out.path("_drawing"), sheets_of(out)))
        out.other_files.push_back(file_row(file, 0, out.part.chordal_error_mm));
    const std::filesystem::path sheet = out.path("_inspection.csv");
    core::write_file(sheet, coupon::empty_inspection(drawing::inspection_sheet(subject_of(out)), out.provenance.line()));
    out.other_files.push_back(file_row(sheet));
}

}  // namespace

Format make_drawing() {
    return {.name = "drawing",
            .extension = ".svg",
            .meaning = "the shop drawing as SVG, with the sheet for the part's inspection",
            .by_default = always,
            .write = write_drawing};
}

}  // namespace fusee::formats
