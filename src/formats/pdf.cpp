#include "common/tool.h"
#include "fusee/core/file.h"
#include "fusee/drawing/sheet.h"

namespace fusee::formats {

Format make_pdf() {
    return {.name = "pdf", .extension = ".pdf", .meaning = "the shop drawing as PDF", .write = [](PartExport& out) {
                const std::filesystem::path pdf = out.path("_drawing.pdf");
                core::write_file(pdf, drawing::pdf(sheets_of(out)));
                out.other_files.push_back(file_row(pdf, 0, out.part.chordal_error_mm));
            }};
}

}  // namespace fusee::formats
