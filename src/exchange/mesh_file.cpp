#include "fusee/exchange/mesh_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "foreign.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"

namespace fusee::exchange {

namespace {

struct Format {
    const char* ending;
    MeshFile (*read)(std::string bytes, const std::filesystem::path&);
    const char* library;
    void (*load)() = nullptr;  ///< the library, where that is not done at the start
};
constexpr double kFarthest_mm = 1e9;  // the largest coordinate of a 3MF (lib3mf, NMR_MESH_MAXCOORDINATE)

constexpr std::array kFormats = {Format{".stl", read_foreign_stl, "assimp"}, Format{".obj", read_foreign_obj, "assimp"},
                                 Format{".3mf", read_foreign_3mf, "lib3mf"},
                                 Format{".step", read_foreign_step, "OpenCASCADE", load_step_reader},
                                 Format{".stp", read_foreign_step, "OpenCASCADE", load_step_reader}};

const Format* format_of(const std::filesystem::path& path) {
    const std::string ending = core::lower(path.extension().string());
    return core::find_by(kFormats, &Format::ending, ending);
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& path) { return format_of(path) != nullptr; }

std::vector<std::string> mesh_endings() { return core::each<std::string>(kFormats, &Format::ending); }

std::string reader_of(const std::filesystem::path& path) { return format_of(path)->library; }

void require_mesh_file(const std::filesystem::path& path) {
    if (!is_mesh_file(path))
        throw core::InvalidInput("mesh", path.string(), fmt::format("a file that ends in {}", fmt::join(mesh_endings(), ", ")));
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw core::IoError(path.string(), "cannot be opened for reading: it does not exist");
    if (!std::filesystem::is_regular_file(status)) throw core::IoError(path.string(), "is not a regular file");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error && size > kMostMeshBytes)
        throw core::IoError(path.string(), fmt::format("has {} bytes; at most {} are read", size, kMostMeshBytes));
}

std::string read_foreign_bytes(const std::filesystem::path& path) {
    require_mesh_file(path);
    std::string bytes = core::read_file(path, kMostMeshBytes);
    if (bytes.empty()) throw core::IoError(path.string(), "is empty");
    return bytes;
}

MeshFile read_mesh_file(const std::filesystem::path& path) { return read_mesh_bytes(read_foreign_bytes(path), path); }

void load_mesh_reader(const std::filesystem::path& path) {
    if (const auto load = format_of(path)->load) load();
}

MeshFile read_mesh_bytes(std::string bytes, const std::filesystem::path& path) {
    MeshFile file = format_of(path)->read(std::move(bytes), path);
    if (file.mesh.triangles.empty()) throw core::IoError(path.string(), "contains no triangles");
    if (file.mesh.triangles.size() > kMostTriangles)
        throw core::IoError(path.string(),
                            fmt::format("contains {} triangles; at most {} are read", file.mesh.triangles.size(), kMostTriangles));
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
