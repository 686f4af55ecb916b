#include "fusee/exchange/stl.h"

#include "fusee/exchange/part_file.h"
#include "fusee/formats/format.h"
#include "fusee/readback/readback.h"

namespace fusee::formats {

Format make_stl() {
    return {.name = "stl",
            .extension = ".stl",
            .place = 1,
            .by_default = always,
            .write_mesh = [](const auto& path, const auto& mesh, const auto&, const auto& line) { exchange::write_stl(path, mesh, line); },
            .read_back = readback::read_stl,
            .is_mirror_image = exchange::is_mirrored_stl};
}

}  // namespace fusee::formats
