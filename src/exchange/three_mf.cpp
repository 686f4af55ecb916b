#include "fusee/exchange/three_mf.h"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <fmt/format.h>

#include <mutex>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/file.h"

namespace fusee::exchange {

namespace {

/// lib3mf promises nothing about threads; one at a time costs little beside the work around it.
std::mutex& library_mutex() {
    static std::mutex mutex;
    return mutex;
}

/// An object of lib3mf, released at the end of its scope. Every kind of handle is the same void** to the C interface.
class Handle {
public:
    Handle() = default;
    ~Handle() {
        if (object_ != nullptr) NMR::lib3mf_release(object_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    [[nodiscard]] NMR::PLib3MFBase* get() const { return object_; }
    [[nodiscard]] NMR::PLib3MFBase** out() { return &object_; }

private:
    NMR::PLib3MFBase* object_ = nullptr;
};

/// @throws IoError with lib3mf's own message, asked from the object on which the call was made
void require(LIB3MFRESULT result, const Handle& object, const std::filesystem::path& path, const char* doing) {
    if (result == 0) return;
    DWORD code = 0;
    LPCSTR message = nullptr;
    if (object.get() != nullptr) NMR::lib3mf_getlasterror(object.get(), &code, &message);
    throw core::IoError(path.string(), fmt::format("lib3mf, {}: {} ({:x})", doing, message == nullptr ? "failed" : message, result));
}

/// An RFC 9562 version 8 UUID made from a hash: the same input names the same object.
std::string uuid_from(std::string_view text) {
    std::string hex = core::sha256_hex(text);
    hex[12] = '8';
    hex[16] = 'a';
    return fmt::format("{}-{}-{}-{}-{}", hex.substr(0, 8), hex.substr(8, 4), hex.substr(12, 4), hex.substr(16, 4), hex.substr(20, 12));
}

std::string digest(const solid::Mesh& mesh, const std::string& name, const std::string& provenance) {
    const auto view = [](const auto& v) { return std::string_view(reinterpret_cast<const char*>(v.data()), v.size() * sizeof v[0]); };
    return core::sha256_hex(view(mesh.points_mm)) + core::sha256_hex(view(mesh.triangles)) + name + provenance;
}

void set_mesh(const Handle& object, const solid::Mesh& mesh) {
    std::vector<NMR::MODELMESHVERTEX> vertices;
    std::vector<NMR::MODELMESHTRIANGLE> triangles;
    vertices.reserve(mesh.points_mm.size());
    triangles.reserve(mesh.triangles.size());
    for (const solid::Vec3& p : mesh.points_mm)
        vertices.push_back({{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])}});
    for (const solid::Triangle& t : mesh.triangles) triangles.push_back({{t[0], t[1], t[2]}});
    const auto result = NMR::lib3mf_meshobject_setgeometry(object.get(), vertices.data(), static_cast<DWORD>(vertices.size()),
                                                           triangles.data(), static_cast<DWORD>(triangles.size()));
    BOOL sound = 0;
    if (result == 0) NMR::lib3mf_meshobject_ismanifoldandoriented(object.get(), &sound);
    if (result != 0 || sound == 0)
        throw core::InvalidInput("mesh", fmt::format("{} triangles", mesh.triangles.size()), "a closed, manifold and oriented surface");
}

/// The one object of the build. @throws IoError
void only_object(const Handle& model, Handle& object, const std::filesystem::path& path) {
    Handle items, item, second;
    BOOL more = 0, transformed = 0;
    require(NMR::lib3mf_model_getbuilditems(model.get(), items.out()), model, path, "listing the build");
    require(NMR::lib3mf_builditemiterator_movenext(items.get(), &more), items, path, "listing the build");
    if (more == 0) throw core::IoError(path.string(), "holds no build item");
    require(NMR::lib3mf_builditemiterator_getcurrent(items.get(), item.out()), items, path, "taking the build item");
    require(NMR::lib3mf_builditem_hasobjecttransform(item.get(), &transformed), item, path, "reading the transform");
    require(NMR::lib3mf_builditemiterator_movenext(items.get(), &more), items, path, "listing the build");
    if (transformed != 0 || more != 0) throw core::IoError(path.string(), "holds more than one untransformed build item");
    require(NMR::lib3mf_builditem_getobjectresource(item.get(), object.out()), item, path, "taking the object");
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

}  // namespace

void write_3mf(const std::filesystem::path& path, const solid::Mesh& mesh, const std::string& name, const std::string& provenance) {
    const std::string seed = digest(mesh, name, provenance);
    std::string bytes;
    {
        const std::scoped_lock lock(library_mutex());
        Handle model, object, item, writer;
        require(NMR::lib3mf_createmodel(model.out()), model, path, "creating the model");
        require(NMR::lib3mf_model_setunit(model.get(), NMR::MODELUNIT_MILLIMETER), model, path, "setting the unit");
        require(NMR::lib3mf_model_addmetadatautf8(model.get(), "Description", provenance.c_str()), model, path, "adding metadata");
        require(NMR::lib3mf_model_addmeshobject(model.get(), object.out()), model, path, "adding the object");
        require(NMR::lib3mf_object_setnameutf8(object.get(), name.c_str()), object, path, "naming the object");
        set_mesh(object, mesh);
        require(NMR::lib3mf_model_addbuilditem(model.get(), object.get(), nullptr, item.out()), model, path, "adding the build item");
        require(NMR::lib3mf_object_setuuidutf8(object.get(), uuid_from("object" + seed).c_str()), object, path, "naming the object");
        require(NMR::lib3mf_builditem_setuuidutf8(item.get(), uuid_from("item" + seed).c_str()), item, path, "naming the build item");
        require(NMR::lib3mf_model_setbuilduuidutf8(model.get(), uuid_from("build" + seed).c_str()), model, path, "naming the build");
        require(NMR::lib3mf_model_querywriter(model.get(), "3mf", writer.out()), model, path, "making the writer");
        // Asking for the stream's size writes the whole stream into memory; the second call writes it again into our buffer.
        ULONG64 size = 0;
        require(NMR::lib3mf_writer_getstreamsize(writer.get(), &size), writer, path, "writing");
        bytes.resize(size);
        require(NMR::lib3mf_writer_writetobuffer(writer.get(), reinterpret_cast<BYTE*>(bytes.data()), size), writer, path, "writing");
    }
    core::write_file(path, bytes);
}

solid::Mesh read_3mf(const std::filesystem::path& path) {
    std::string bytes = core::read_file(path);
    if (bytes.empty()) throw core::IoError(path.string(), "is empty");
    const std::scoped_lock lock(library_mutex());
    Handle model, reader, object;
    require(NMR::lib3mf_createmodel(model.out()), model, path, "creating the model");
    require(NMR::lib3mf_model_queryreader(model.get(), "3mf", reader.out()), model, path, "making the reader");
    require(NMR::lib3mf_reader_readfrombuffer(reader.get(), reinterpret_cast<BYTE*>(bytes.data()), bytes.size()), reader, path, "reading");
    DWORD unit = 0;
    require(NMR::lib3mf_model_getunit(model.get(), &unit), model, path, "reading the unit");
    if (unit != NMR::MODELUNIT_MILLIMETER) throw core::IoError(path.string(), "is not in millimetres");
    only_object(model, object, path);
    return take_mesh(object, path);
}

}  // namespace fusee::exchange
