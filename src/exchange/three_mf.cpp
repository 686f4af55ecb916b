#include "fusee/exchange/three_mf.h"

#include <fmt/format.h>

#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "lib3mf.h"

namespace fusee::exchange {

namespace {

std::string digest(const NamedMesh& object) {
    const auto view = [](const auto& v) { return std::string_view(reinterpret_cast<const char*>(v.data()), v.size() * sizeof v[0]); };
    const std::string colour = object.colour ? core::sha256_hex(view(*object.colour)) : "";
    return core::sha256_hex(view(object.mesh.points_mm)) + core::sha256_hex(view(object.mesh.triangles)) + object.name + colour;
}

void set_mesh(const Handle& object, const solid::Mesh& mesh) {
    const auto result = set_geometry(object, mesh.points_mm, mesh.triangles);
    if (result != 0 || !solid::is_closed_and_oriented(mesh.triangles))  // lib3mf's own test takes longer than its writing
        throw core::InvalidInput("mesh", fmt::format("{} triangles", mesh.triangles.size()), "a closed, manifold and oriented surface");
}

/// The whole object's.
void set_colour(const Handle& object, const Colour& colour, const std::filesystem::path& path) {
    Handle usual;
    require(NMR::lib3mf_object_createdefaultpropertyhandler(object.get(), usual.out()), object, path, "colouring");
    NMR::MODELMESHCOLOR_SRGB colour_of_all{colour[0], colour[1], colour[2], 255};
    require(NMR::lib3mf_defaultpropertyhandler_setcolor(usual.get(), &colour_of_all), usual, path, "colouring");
}

/// One object and its build item. @param seed for their UUIDs
void add(const Handle& model, const NamedMesh& named, const std::string& seed, const std::filesystem::path& path) {
    Handle object, item;
    require(NMR::lib3mf_model_addmeshobject(model.get(), object.out()), model, path, "adding the object");
    set_name(object, named.name, path);
    set_mesh(object, named.mesh);
    if (named.colour) set_colour(object, *named.colour, path);
    require(NMR::lib3mf_model_addbuilditem(model.get(), object.get(), nullptr, item.out()), model, path, "adding the build item");
    require(NMR::lib3mf_object_setuuidutf8(object.get(), uuid_from("object" + seed).c_str()), object, path, "naming the object");
    require(NMR::lib3mf_builditem_setuuidutf8(item.get(), uuid_from("item" + seed).c_str()), item, path, "naming the build item");
}

/// lib3mf returns the text between two tags without decoding it.
std::string unescaped(std::string text) {
    constexpr std::array<std::pair<const char*, const char*>, 5> kEntities{
        {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}}};  // & is last: &amp;lt; is &lt;
    for (const auto& [entity, character] : kEntities)
        for (std::size_t at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1))
            text.replace(at, std::char_traits<char>::length(entity), character);
    return text;
}

}  // namespace

void write_3mf(const std::filesystem::path& path, const std::vector<NamedMesh>& objects, const std::string& provenance) {
    std::string all = provenance, bytes;
    {
        const std::scoped_lock lock(library_mutex());
        Handle model;
        make_model(model, path);
        set_description(model, provenance, path);
        for (const NamedMesh& object : objects) {
            all += digest(object);
            add(model, object, all, path);
        }
        require(NMR::lib3mf_model_setbuilduuidutf8(model.get(), uuid_from("build" + all).c_str()), model, path, "naming the build");
        bytes = bytes_of(model, path);
    }
    core::write_file(path, bytes);
}

void write_3mf(const std::filesystem::path& path, const solid::Mesh& mesh, const std::string& name, const std::string& provenance) {
    write_3mf(path, {{name, mesh}}, provenance);
}

std::vector<NamedMesh> read_3mf_objects(const std::filesystem::path& path) {
    const std::scoped_lock lock(library_mutex());
    Handle model;
    read_model(model, core::read_file(path), path);
    DWORD unit = 0;
    require(NMR::lib3mf_model_getunit(model.get(), &unit), model, path, "reading the unit");
    if (unit != NMR::MODELUNIT_MILLIMETER) throw core::IoError(path.string(), "is not in millimetres");
    std::vector<NamedMesh> objects;
    for_each_item(model, path, [&](const Handle& item, const Handle& object) {
        BOOL transformed = 0;
        require(NMR::lib3mf_builditem_hasobjecttransform(item.get(), &transformed), item, path, "reading the transform");
        if (transformed != 0) throw core::IoError(path.string(), "contains a build item with a transform");
        objects.push_back({name_of(object, path), take_mesh(object, path)});
    });
    if (objects.empty()) throw core::IoError(path.string(), "contains no build item");
    return objects;
}

std::string read_3mf_description(const std::filesystem::path& path) {
    const std::scoped_lock lock(library_mutex());
    Handle model;
    read_model(model, core::read_file(path), path);
    DWORD count = 0;
    require(NMR::lib3mf_model_getmetadatacount(model.get(), &count), model, path, "counting metadata");
    const auto text = [&](auto get, DWORD i) {
        ULONG bytes = 0;  // without the final 0
        require(get(model.get(), i, nullptr, 0, &bytes), model, path, "reading metadata");
        std::string value(bytes + 1, '\0');
        require(get(model.get(), i, value.data(), bytes + 1, &bytes), model, path, "reading metadata");
        value.resize(bytes);
        return value;
    };
    for (DWORD i = 0; i < count; ++i)
        if (text(NMR::lib3mf_model_getmetadatakeyutf8, i) == "Description")
            return unescaped(text(NMR::lib3mf_model_getmetadatavalueutf8, i));
    return "";
}

solid::Mesh read_3mf(const std::filesystem::path& path) {
    std::vector<NamedMesh> objects = read_3mf_objects(path);
    if (objects.size() != 1) throw core::IoError(path.string(), "contains more than one build item");
    return std::move(objects.front().mesh);
}

}  // namespace fusee::exchange
