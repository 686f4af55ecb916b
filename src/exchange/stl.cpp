#include "fusee/exchange/stl.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <mutex>
#include <sstream>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/kept.h"
#include "stl_bytes.h"
#include "weld.h"

namespace fusee::exchange {

namespace {

using Float3 = std::array<float, 3>;

Float3 rounded(const solid::Vec3& p) { return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])}; }

/// The normal of the rounded triangle, so that it agrees with the vertices; zero if rounding leaves no area.
Float3 normal(const Float3& a, const Float3& b, const Float3& c) {
    const double ux = double(b[0]) - a[0], uy = double(b[1]) - a[1], uz = double(b[2]) - a[2];
    const double vx = double(c[0]) - a[0], vy = double(c[1]) - a[1], vz = double(c[2]) - a[2];
    const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
    return length > 0.0 ? rounded({nx / length, ny / length, nz / length}) : Float3{};
}

using Surface = OpenMesh::TriMesh_ArrayKernelT<>;

/// The readers and the error stream of OpenMesh are singletons.
bool read_surface(Surface& surface, std::istream& in) {
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
    omerr().disable();  // its reports become an IoError
    OpenMesh::IO::Options options(OpenMesh::IO::Options::Binary);
    return OpenMesh::IO::read_mesh(surface, in, ".STLB", options);
}

/// The mesh of the bytes, if OpenMesh finds all triangles and no point twice.
solid::Mesh mesh_by_openmesh(const std::string& bytes, const std::filesystem::path& path) {
    const std::size_t stated = (bytes.size() - kStlHeader - 4) / kStlTriangle;
    std::istringstream in(bytes, std::ios::binary);
    Surface surface;
    if (!read_surface(surface, in)) throw core::IoError(path.string(), "OpenMesh cannot read it");
    if (surface.n_faces() != stated)
        throw core::IoError(path.string(), fmt::format("OpenMesh accepts {} of {} triangles", surface.n_faces(), stated));
    solid::Mesh mesh;
    mesh.points_mm.reserve(surface.n_vertices());
    Welder distinct;
    for (const auto vertex : surface.vertices()) {
        const auto& p = surface.point(vertex);
        mesh.points_mm.push_back({p[0], p[1], p[2]});
        (void)distinct.index({p[0], p[1], p[2]});
    }
    // OpenMesh duplicates the corners of a face that would make an edge or a point complex.
    if (distinct.mesh().points_mm.size() != mesh.points_mm.size())
        throw core::IoError(path.string(), "OpenMesh splits it: the surface is not manifold");
    mesh.triangles.reserve(surface.n_faces());
    for (const auto face : surface.faces()) {
        solid::Triangle t{};
        std::size_t k = 0;
        for (const auto vertex : surface.fv_range(face)) t[k++] = static_cast<std::uint32_t>(vertex.idx());
        mesh.triangles.push_back(t);
    }
    return mesh;
}

}  // namespace

void write_stl(const std::filesystem::path& path, const solid::Mesh& mesh, const std::string& provenance) {
    if (provenance.starts_with("solid")) throw core::InvalidInput("provenance", provenance, "a line that does not begin with \"solid\"");
    std::string bytes = provenance.substr(0, kStlHeader);
    bytes.resize(kStlHeader, ' ');
    bytes.resize(kStlHeader + 4 + kStlTriangle * mesh.triangles.size());  // the attribute byte count of each triangle stays 0
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    char* at = bytes.data() + kStlHeader;
    std::memcpy(at, &count, sizeof count);
    at += sizeof count;
    for (const solid::Triangle& t : mesh.triangles) {
        for (const std::uint32_t index : t)
            if (index >= mesh.points_mm.size())
                throw core::InvalidInput("mesh.triangles", fmt::format("{}", index), fmt::format("below {}", mesh.points_mm.size()));
        const std::array<Float3, 3> corner{rounded(mesh.points_mm[t[0]]), rounded(mesh.points_mm[t[1]]), rounded(mesh.points_mm[t[2]])};
        const Float3 n = normal(corner[0], corner[1], corner[2]);
        std::memcpy(at, n.data(), sizeof n);
        std::memcpy(at + sizeof n, corner.data(), sizeof corner);
        at += kStlTriangle;
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

// What a reader found in the same triangles is taken over: reading takes most of a read-back.
namespace {

solid::Mesh read_or_known(const std::filesystem::path& path, core::Kept<std::string, solid::Mesh>& known,
                          const std::function<solid::Mesh(const std::string&)>& read) {
    constexpr std::size_t kMostBytes = 1 << 21;
    const std::string bytes = read_stl_bytes(path);
    std::string triangles = bytes.substr(kStlHeader);
    if (auto mesh = known.find(triangles)) return std::move(*mesh);
    solid::Mesh mesh = read(bytes);
    if (triangles.size() <= kMostBytes) known.keep(std::move(triangles), mesh);
    return mesh;
}

constexpr std::size_t kFiles = 8;

}  // namespace

solid::Mesh read_stl_assimp(const std::filesystem::path& path) {
    static core::Kept<std::string, solid::Mesh> files(kFiles);
    return read_or_known(path, files, [&](const std::string& bytes) { return mesh_by_assimp(bytes, "stl", path); });
}

solid::Mesh read_stl_openmesh(const std::filesystem::path& path) {
    static core::Kept<std::string, solid::Mesh> files(kFiles);
    return read_or_known(path, files, [&](const std::string& bytes) { return mesh_by_openmesh(bytes, path); });
}

}  // namespace fusee::exchange
