#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>
#include <cstring>

#include "foreign.h"
#include "fusee/core/error.h"
#include "fusee/exchange/stl.h"
#include "stl_bytes.h"
#include "weld.h"

namespace fusee::exchange {

namespace {

solid::Mesh parsed(const std::string& bytes, const char* format, const std::filesystem::path& path) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate, format);
    if (scene == nullptr) throw core::IoError(path.string(), fmt::format("assimp: {}", importer.GetErrorString()));
    return welded(*scene, path);
}

/// The first bytes do not distinguish text from binary; only a binary file has the length of its count of triangles.
bool is_binary_stl(const std::string& bytes) {
    if (bytes.size() < kStlHeader + 4) return false;
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kStlHeader, sizeof count);
    return bytes.size() == kStlHeader + 4 + kStlTriangle * std::size_t{count} || !bytes.starts_with("solid");
}

constexpr const char* kNoUnit = "none, taken as millimetres";

}  // namespace

MeshFile read_foreign_stl(const std::filesystem::path& path) {
    const std::string bytes = read_foreign_bytes(path);
    if (is_binary_stl(bytes)) return {read_stl_assimp(path), kNoUnit};
    // assimp accepts a text file that is cut short.
    if (bytes.find("endsolid") == std::string::npos) throw core::IoError(path.string(), "is a text STL without its end (endsolid)");
    if (bytes.find("facet") == std::string::npos) throw core::IoError(path.string(), "contains no triangles");
    return {parsed(bytes, "stl", path), kNoUnit};
}

MeshFile read_foreign_obj(const std::filesystem::path& path) {
    const std::string bytes = read_foreign_bytes(path);
    require_sound_obj(bytes, path);
    return {parsed(bytes, "obj", path), kNoUnit};
}

}  // namespace fusee::exchange
