#include <fmt/format.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <mutex>
#include <sstream>

#include "fusee/core/error.h"
#include "fusee/core/kept.h"
#include "fusee/exchange/stl.h"
#include "stl_bytes.h"
#include "weld.h"

namespace fusee::exchange {

namespace {

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

// OpenMesh takes most of a read-back: what it found in the same triangles is taken over.
solid::Mesh read_stl_openmesh(const std::filesystem::path& path) {
    constexpr std::size_t kFiles = 8, kMostBytes = 1 << 21;
    static core::Kept<std::string, solid::Mesh> files(kFiles);
    const std::string bytes = read_stl_bytes(path);
    std::string triangles = bytes.substr(kStlHeader);
    if (auto known = files.find(triangles)) return std::move(*known);
    solid::Mesh mesh = mesh_by_openmesh(bytes, path);
    if (triangles.size() <= kMostBytes) files.keep(std::move(triangles), mesh);
    return mesh;
}

}  // namespace fusee::exchange
