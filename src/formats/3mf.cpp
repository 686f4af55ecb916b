#include "fusee/exchange/three_mf.h"
#include "fusee/formats/format.h"
#include "fusee/readback/readback.h"

namespace fusee::formats {

Format make_3mf() {
    return {.name = "3mf",
            .extension = ".3mf",
            .place = 2,
            .by_default = always,
            .write_mesh = [](const auto& path, const auto& mesh, const auto& name,
                             const auto& line) { exchange::write_3mf(path, mesh, name, line); },
            .read_back = readback::read_3mf};
}

}  // namespace fusee::formats
