#include "fusee/exchange/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "foreign.h"
#include "fusee/core/error.h"

namespace fusee::exchange {

namespace {

struct Format {
    const char* ending;
    MeshFile (*read)(const std::filesystem::path&);
};
constexpr double kFarthest_mm = 1e9;  // 3MF holds no coordinate beyond (lib3mf, NMR_MESH_MAXCOORDINATE)

constexpr std::array kFormats = {Format{".stl", read_foreign_stl}, Format{".obj", read_foreign_obj}, Format{".3mf", read_foreign_3mf},
                                 Format{".step", read_foreign_step}, Format{".stp", read_foreign_step}};

const Format* format_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) { return ending == f.ending; });
    return found == kFormats.end() ? nullptr : found;
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& path) { return format_of(path) != nullptr; }

MeshFile read_mesh_file(const std::filesystem::path& path) {
    const Format* format = format_of(path);
    if (format == nullptr) throw core::InvalidInput("mesh", path.string(), "a file that ends in .stl, .obj, .3mf, .step or .stp");
    MeshFile file = format->read(path);
    if (file.mesh.triangles.empty()) throw core::IoError(path.string(), "holds no triangles");
    for (std::size_t i = 0; i < file.mesh.points_mm.size(); ++i)
        for (const double x : file.mesh.points_mm[i]) {
            if (!std::isfinite(x)) throw core::IoError(path.string(), fmt::format("point {} has a coordinate that is not finite", i));
            if (std::abs(x) > kFarthest_mm)
                throw core::IoError(path.string(),
                                    fmt::format("point {} has a coordinate of {:g} mm; at most {:g} mm are read", i, x, kFarthest_mm));
        }
    return file;
}

}  // namespace fusee::exchange
