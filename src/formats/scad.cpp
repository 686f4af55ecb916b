#include "fusee/exchange/scad.h"

#include "fusee/formats/format.h"

namespace fusee::formats {

Format make_scad() {
    return {.name = "scad", .extension = ".scad", .place = 3, .by_default = always, .write = [](PartExport& out) {
                const std::filesystem::path scad = out.path(".scad");
                exchange::write_scad(scad, out.part, out.provenance.line());
                out.state(scad, 0, out.part.chordal_error_mm);
            }};
}

}  // namespace fusee::formats
