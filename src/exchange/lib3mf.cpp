#include "lib3mf.h"

#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/core/file.h"

namespace fusee::exchange {

std::mutex& library_mutex() {
    static std::mutex mutex;
    return mutex;
}

void require(LIB3MFRESULT result, const Handle& object, const std::filesystem::path& path, const char* doing) {
    if (result == 0) return;
    DWORD code = 0;
    LPCSTR message = nullptr;
    if (object.get() != nullptr) NMR::lib3mf_getlasterror(object.get(), &code, &message);
    throw core::IoError(path.string(), fmt::format("{} by lib3mf: {}", doing, message == nullptr ? "failed" : message));
}

std::string uuid_from(std::string_view text) {
    std::string hex = core::sha256_hex(text);
    hex[12] = '8';
    hex[16] = 'a';
    return fmt::format("{}-{}-{}-{}-{}", hex.substr(0, 8), hex.substr(8, 4), hex.substr(12, 4), hex.substr(16, 4), hex.substr(20, 12));
}

std::string bytes_of(const Handle& model, const std::filesystem::path& path) {
    Handle writer;
    require(NMR::lib3mf_model_querywriter(model.get(), "3mf", writer.out()), model, path, "making the writer");
    // Asking for the stream's size writes the whole stream into memory; the second call writes it again into our buffer.
    ULONG64 size = 0;
    require(NMR::lib3mf_writer_getstreamsize(writer.get(), &size), writer, path, "writing");
    std::string bytes(size, '\0');
    require(NMR::lib3mf_writer_writetobuffer(writer.get(), reinterpret_cast<BYTE*>(bytes.data()), size), writer, path, "writing");
    return bytes;
}

solid::Mesh take_mesh(const Handle& object, const std::filesystem::path& path) {
    DWORD points = 0, triangles = 0;
    require(NMR::lib3mf_meshobject_getvertexcount(object.get(), &points), object, path, "counting vertices");
    require(NMR::lib3mf_meshobject_gettrianglecount(object.get(), &triangles), object, path, "counting triangles");
    if (triangles == 0) throw core::IoError(path.string(), "holds no triangles");
    std::vector<NMR::MODELMESHVERTEX> vertex(points);
    std::vector<NMR::MODELMESHTRIANGLE> triangle(triangles);
    require(NMR::lib3mf_meshobject_getvertices(object.get(), vertex.data(), points, nullptr), object, path, "reading vertices");
    require(NMR::lib3mf_meshobject_gettriangleindices(object.get(), triangle.data(), triangles, nullptr), object, path,
            "reading triangles");
    solid::Mesh mesh;
    mesh.points_mm.reserve(points);
    mesh.triangles.reserve(triangles);
    for (const auto& v : vertex) mesh.points_mm.push_back({v.m_fPosition[0], v.m_fPosition[1], v.m_fPosition[2]});
    for (const auto& t : triangle) mesh.triangles.push_back({t.m_nIndices[0], t.m_nIndices[1], t.m_nIndices[2]});
    return mesh;
}

}  // namespace fusee::exchange
