#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cstring>

#include "foreign.h"
#include "fusee/core/error.h"
#include "fusee/core/text.h"
#include "stl_bytes.h"
#include "weld.h"

namespace fusee::exchange {

namespace {

/// The file system of a reader that has its file in memory: there is no other file, so that none is read that the file refers to (the
/// materials of an OBJ).
class NoFiles : public Assimp::IOSystem {
public:
    [[nodiscard]] bool Exists(const char* /*file*/) const override { return false; }
    [[nodiscard]] char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* /*file*/, const char* /*mode*/) override { return nullptr; }
    void Close(Assimp::IOStream* stream) override { delete stream; }
};

/// Behind a byte order mark and blanks.
std::size_t begin_of_text(const std::string& bytes) {
    const std::size_t mark = bytes.starts_with(core::kByteOrderMark) ? core::kByteOrderMark.size() : 0;
    return std::min(bytes.find_first_not_of(" \t\r\n", mark), bytes.size());
}

bool begins_with_solid(const std::string& bytes) { return core::lower(bytes.substr(begin_of_text(bytes), 5)) == "solid"; }

/// The first bytes do not distinguish text from binary; only a binary file has the length of its count of triangles.
bool is_binary_stl(const std::string& bytes) {
    if (bytes.size() < kStlHeader + 4) return false;
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kStlHeader, sizeof count);
    return bytes.size() == kStlHeader + 4 + kStlTriangle * std::size_t{count} || !begins_with_solid(bytes);
}

constexpr const char* kNoUnit = "none, taken as millimetres";

}  // namespace

solid::Mesh mesh_by_assimp(const std::string& bytes, const char* format, const std::filesystem::path& path) {
    Assimp::Importer importer;
    importer.SetIOHandler(new NoFiles);  // the importer's from here on
    const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate, format);
    if (scene == nullptr || scene->mNumMeshes == 0)
        throw core::IoError(path.string(), fmt::format("assimp: {}", importer.GetErrorString()));
    return welded(*scene, path);
}

MeshFile read_foreign_stl(std::string bytes, const std::filesystem::path& path) {
    if (is_binary_stl(bytes)) {
        require_binary_stl(bytes, path);
        return {mesh_by_assimp(bytes, "stl", path), kNoUnit};
    }
    // Keywords may be in capitals, but assimp knows small ones only, at the very beginning; names have no meaning here.
    const std::string text = core::lower(bytes.substr(begin_of_text(bytes)));
    // assimp accepts a text file that is cut short.
    if (text.find("endsolid") == std::string::npos) throw core::IoError(path.string(), "is a text STL without its end (endsolid)");
    if (text.find("facet") == std::string::npos) throw core::IoError(path.string(), "contains no triangles");
    return {mesh_by_assimp(text, "stl", path), kNoUnit};
}

MeshFile read_foreign_obj(std::string bytes, const std::filesystem::path& path) {
    require_sound_obj(bytes, path);
    return {mesh_by_assimp(bytes, "obj", path), kNoUnit};
}

}  // namespace fusee::exchange
