#include "fusee/exchange/stl.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "stl_bytes.h"
#include "weld.h"

namespace fusee::exchange {

namespace {

using Float3 = std::array<float, 3>;

Float3 rounded(const solid::Vec3& p) { return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])}; }

void append_bytes(std::string& bytes, const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); }

/// The normal of the rounded triangle, so that it agrees with the vertices; zero if rounding leaves no area.
Float3 normal(const Float3& a, const Float3& b, const Float3& c) {
    const double ux = double(b[0]) - a[0], uy = double(b[1]) - a[1], uz = double(b[2]) - a[2];
    const double vx = double(c[0]) - a[0], vy = double(c[1]) - a[1], vz = double(c[2]) - a[2];
    const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
    return length > 0.0 ? rounded({nx / length, ny / length, nz / length}) : Float3{};
}

}  // namespace

void write_stl(const std::filesystem::path& path, const solid::Mesh& mesh, const std::string& provenance) {
    if (provenance.starts_with("solid")) throw core::InvalidInput("provenance", provenance, "a line that does not begin with \"solid\"");
    std::string bytes = provenance.substr(0, kStlHeader);
    bytes.resize(kStlHeader, ' ');
    bytes.reserve(kStlHeader + 4 + kStlTriangle * mesh.triangles.size());
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    append_bytes(bytes, &count, sizeof count);
    for (const solid::Triangle& t : mesh.triangles) {
        for (const std::uint32_t index : t)
            if (index >= mesh.points_mm.size())
                throw core::InvalidInput("mesh.triangles", fmt::format("{}", index), fmt::format("below {}", mesh.points_mm.size()));
        const std::array<Float3, 3> corner{rounded(mesh.points_mm[t[0]]), rounded(mesh.points_mm[t[1]]), rounded(mesh.points_mm[t[2]])};
        const Float3 n = normal(corner[0], corner[1], corner[2]);
        append_bytes(bytes, n.data(), sizeof n);
        append_bytes(bytes, corner.data(), sizeof corner);
        bytes.append(2, '\0');  // attribute byte count
    }
    core::write_file(path, bytes);
}

void require_binary_stl(const std::string& bytes, const std::filesystem::path& path) {
    if (bytes.size() < kStlHeader + 4) throw core::IoError(path.string(), "is not a binary STL: shorter than its header");
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kStlHeader, sizeof count);
    if (count == 0) throw core::IoError(path.string(), "contains no triangles");
    if (bytes.size() != kStlHeader + 4 + kStlTriangle * count)
        throw core::IoError(path.string(), fmt::format("is not a binary STL: {} bytes for {} triangles", bytes.size(), count));
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 12> row{};
        std::memcpy(row.data(), bytes.data() + kStlHeader + 4 + kStlTriangle * i, sizeof row);
        for (std::size_t k = 3; k < row.size(); ++k)
            if (!std::isfinite(row[k])) throw core::IoError(path.string(), fmt::format("triangle {} has a corner that is not finite", i));
    }
}

std::string read_stl_bytes(const std::filesystem::path& path) {
    std::string bytes = core::read_file(path);
    require_binary_stl(bytes, path);
    return bytes;
}

solid::Mesh welded(const aiScene& scene, const std::filesystem::path& path) {
    // The joining of assimp merges points closer than 1e-5. The corners of one STL vertex are equal bit by bit and need no tolerance.
    Welder welder;
    for (unsigned int m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& part = *scene.mMeshes[m];
        for (unsigned int f = 0; f < part.mNumFaces; ++f) {
            const aiFace& face = part.mFaces[f];
            if (face.mNumIndices != 3) throw core::IoError(path.string(), "assimp: a face is not a triangle");
            solid::Triangle t{};
            for (unsigned int k = 0; k < 3; ++k) {
                const aiVector3D& p = part.mVertices[face.mIndices[k]];
                t[k] = welder.index({p.x, p.y, p.z});
            }
            welder.mesh().triangles.push_back(t);
        }
    }
    return std::move(welder.mesh());
}

solid::Mesh read_stl_assimp(const std::filesystem::path& path) { return mesh_by_assimp(read_stl_bytes(path), "stl", path); }

}  // namespace fusee::exchange
