#include "common/sheets.h"
#include "fusee/drawing/svg.h"
#include "fusee/formats/format.h"

namespace fusee::formats {

Format make_drawing() {
    return {
        .name = "drawing", .extension = ".svg", .meaning = "the shop drawing as SVG", .by_default = always, .write = [](PartExport& out) {
            for (const std::filesystem::path& file : drawing::write_svg(out.path("_drawing"), sheets_of(out)))
                out.other_files.push_back(file_row(file, 0, out.part.chordal_error_mm));
        }};
}

}  // namespace fusee::formats
