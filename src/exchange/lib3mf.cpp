#include "lib3mf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/markup.h"

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

namespace {

/// Bytes of the UTF-8 character at the beginning of `text`; 0 if it is not valid in XML.
std::size_t character(std::string_view text) {
    const auto byte = [text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned first = byte(0);
    if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
    const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    static constexpr unsigned kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    unsigned code = first & (0x7FU >> size);
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0U) != 0x80) return 0;
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    const bool allowed = code >= kLeast[size] && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF) && code != 0xFFFE && code != 0xFFFF;
    return first >= 0xC0 && first < 0xF8 && allowed ? size : 0;
}

}  // namespace

std::string xml_text(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t size = character(text);
        out += size == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(0, size);
        text.remove_prefix(std::max<std::size_t>(size, 1));
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
