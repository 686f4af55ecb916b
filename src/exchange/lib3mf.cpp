#include "lib3mf.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <new>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/text.h"

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

void make_model(Handle& model, const std::filesystem::path& path) {
    require(NMR::lib3mf_createmodel(model.out()), model, path, "creating the model");
    require(NMR::lib3mf_model_setunit(model.get(), NMR::MODELUNIT_MILLIMETER), model, path, "setting the unit");
}

void read_model(Handle& model, std::string bytes, const std::filesystem::path& path) {
    if (bytes.empty()) throw core::IoError(path.string(), "is empty");
    Handle reader;
    require(NMR::lib3mf_createmodel(model.out()), model, path, "creating the model");
    require(NMR::lib3mf_model_queryreader(model.get(), "3mf", reader.out()), model, path, "making the reader");
    require(NMR::lib3mf_reader_readfrombuffer(reader.get(), reinterpret_cast<BYTE*>(bytes.data()), bytes.size()), reader, path, "reading");
}

void for_each_item(const Handle& model, const std::filesystem::path& path, const std::function<void(const Handle&, const Handle&)>& use) {
    Handle items;
    require(NMR::lib3mf_model_getbuilditems(model.get(), items.out()), model, path, "listing the build");
    for (BOOL more = 0;;) {
        require(NMR::lib3mf_builditemiterator_movenext(items.get(), &more), items, path, "listing the build");
        if (more == 0) return;
        Handle item, object;
        require(NMR::lib3mf_builditemiterator_getcurrent(items.get(), item.out()), items, path, "taking the build item");
        require(NMR::lib3mf_builditem_getobjectresource(item.get(), object.out()), item, path, "taking the object");
        use(item, object);
    }
}

std::string uuid_from(std::string_view text) {
    std::string hex = core::sha256_hex(text);
    hex[12] = '8';
    hex[16] = 'a';
    return fmt::format("{}-{}-{}-{}-{}", hex.substr(0, 8), hex.substr(8, 4), hex.substr(12, 4), hex.substr(16, 4), hex.substr(20, 12));
}

std::string xml_text(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const core::Character c = core::first_character(text);
        const bool allowed = (c.code >= 0x20 && c.code != 0xFFFE && c.code != 0xFFFF) || c.code == '\t' || c.code == '\n' || c.code == '\r';
        out += c.valid && allowed ? text.substr(0, c.bytes) : std::string_view("\xEF\xBF\xBD");
        text.remove_prefix(c.bytes);
    }
    return out;
}

std::string name_of(const Handle& object, const std::filesystem::path& path) {
    ULONG bytes = 0;  // without the final 0
    require(NMR::lib3mf_object_getnameutf8(object.get(), nullptr, 0, &bytes), object, path, "reading a name");
    std::string name(bytes + 1, '\0');
    require(NMR::lib3mf_object_getnameutf8(object.get(), name.data(), bytes + 1, &bytes), object, path, "reading a name");
    name.resize(bytes);
    return name;
}

void set_name(const Handle& object, const std::string& name, const std::filesystem::path& path) {
    require(NMR::lib3mf_object_setnameutf8(object.get(), xml_text(name).c_str()), object, path, "naming the object");
}

void set_description(const Handle& model, const std::string& text, const std::filesystem::path& path) {
    require(NMR::lib3mf_model_addmetadatautf8(model.get(), "Description", core::escape(xml_text(text)).c_str()), model, path,
            "adding metadata");
}

namespace {

/// The bytes that lib3mf writes, and its place in them.
struct Written {
    std::string bytes;
    std::size_t at = 0;
};

std::uint32_t write_piece(std::uint8_t* data, std::uint32_t size, void* user) noexcept {
    Written& out = *static_cast<Written*>(user);
    try {
        if (out.bytes.size() < out.at + size) out.bytes.resize(out.at + size);
    } catch (const std::bad_alloc&) {
        return 1;
    }
    std::memcpy(out.bytes.data() + out.at, data, size);
    out.at += size;
    return 0;
}

std::uint32_t seek(std::uint64_t position, void* user) noexcept {
    static_cast<Written*>(user)->at = position;
    return 0;
}

}  // namespace

std::string bytes_of(const Handle& model, const std::filesystem::path& path) {
    Handle writer;
    require(NMR::lib3mf_model_querywriter(model.get(), "3mf", writer.out()), model, path, "making the writer");
    Written out;  // a query of the size would write everything twice
    require(NMR::lib3mf_writer_writetocallback(writer.get(), reinterpret_cast<void*>(write_piece), reinterpret_cast<void*>(seek), &out),
            writer, path, "writing");
    return std::move(out.bytes);
}

LIB3MFRESULT set_geometry(const Handle& object, const std::vector<solid::Vec3>& points_mm, const std::vector<solid::Triangle>& triangles) {
    std::vector<NMR::MODELMESHVERTEX> vertex;
    std::vector<NMR::MODELMESHTRIANGLE> triangle;
    vertex.reserve(points_mm.size());
    triangle.reserve(triangles.size());
    for (const solid::Vec3& p : points_mm)
        vertex.push_back({{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])}});
    for (const solid::Triangle& t : triangles) triangle.push_back({{t[0], t[1], t[2]}});
    return NMR::lib3mf_meshobject_setgeometry(object.get(), vertex.data(), static_cast<DWORD>(vertex.size()), triangle.data(),
                                              static_cast<DWORD>(triangle.size()));
}

solid::Mesh take_mesh(const Handle& object, const std::filesystem::path& path) {
    DWORD points = 0, triangles = 0;
    require(NMR::lib3mf_meshobject_getvertexcount(object.get(), &points), object, path, "counting vertices");
    require(NMR::lib3mf_meshobject_gettrianglecount(object.get(), &triangles), object, path, "counting triangles");
    if (triangles == 0) throw core::IoError(path.string(), "contains no triangles");
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
