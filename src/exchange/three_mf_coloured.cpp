#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/exchange/three_mf.h"
#include "lib3mf.h"

namespace fusee::exchange {

namespace {

NMR::MODELMESHCOLOR_SRGB srgb(const Colour& c) {
    NMR::MODELMESHCOLOR_SRGB colour{};
    colour.m_Red = c[0], colour.m_Green = c[1], colour.m_Blue = c[2], colour.m_Alpha = 255;
    return colour;
}

bool has_three_corners(const solid::Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; }

/// Mesh, type and colours of one object. In 3MF only a closed, manifold and oriented mesh is a model; any other is a surface.
void fill(const Handle& model, const Handle& object, const solid::Mesh& mesh, const std::vector<Colour>& colours,
          const std::filesystem::path& path) {
    std::vector<solid::Triangle> kept;
    std::vector<NMR::MODELMESHCOLOR_SRGB> painted;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const solid::Triangle& t = mesh.triangles[i];
        if (!has_three_corners(t)) continue;  // 3MF has none
        kept.push_back(t);
        painted.push_back(srgb(colours[i]));
    }
    require(set_geometry(object, mesh.points_mm, kept), object, path, "taking the mesh");
    if (!solid::is_closed_and_oriented(kept))
        require(NMR::lib3mf_object_settype(object.get(), NMR::MODELOBJECTTYPE_SURFACE), object, path, "setting the type");
    Handle usual, handler, item;
    require(NMR::lib3mf_object_createdefaultpropertyhandler(object.get(), usual.out()), object, path, "colouring");
    NMR::MODELMESHCOLOR_SRGB grey = srgb(kGrey);
    require(NMR::lib3mf_defaultpropertyhandler_setcolor(usual.get(), &grey), usual, path, "colouring");
    require(NMR::lib3mf_meshobject_createpropertyhandler(object.get(), handler.out()), object, path, "colouring");
    require(NMR::lib3mf_propertyhandler_setsinglecolorarray(handler.get(), painted.data()), handler, path, "colouring");
    require(NMR::lib3mf_model_addbuilditem(model.get(), object.get(), nullptr, item.out()), model, path, "adding the build item");
    require(NMR::lib3mf_builditem_setuuidutf8(item.get(), uuid_from("item").c_str()), item, path, "naming the build item");
}

}  // namespace

void write_coloured_3mf(const std::filesystem::path& path, const solid::Mesh& mesh, const std::vector<Colour>& colours,
                        const std::string& name, const std::string& provenance) {
    if (colours.size() != mesh.triangles.size())
        throw core::InvalidInput("colours", fmt::format("{}", colours.size()), fmt::format("{}, one per triangle", mesh.triangles.size()));
    std::string bytes;
    {
        const std::scoped_lock lock(library_mutex());
        Handle model, object;
        make_model(model, path);
        set_description(model, provenance, path);
        require(NMR::lib3mf_model_addmeshobject(model.get(), object.out()), model, path, "adding the object");
        set_name(object, name, path);
        fill(model, object, mesh, colours, path);
        require(NMR::lib3mf_object_setuuidutf8(object.get(), uuid_from("object").c_str()), object, path, "naming the object");
        require(NMR::lib3mf_model_setbuilduuidutf8(model.get(), uuid_from("build").c_str()), model, path, "naming the build");
        bytes = bytes_of(model, path);
    }
    core::write_file(path, bytes);
}

std::vector<Colour> read_3mf_colours(const std::filesystem::path& path) {
    const std::scoped_lock lock(library_mutex());
    Handle model, objects, object, handler;
    read_model(model, core::read_file(path), path);
    require(NMR::lib3mf_model_getmeshobjects(model.get(), objects.out()), model, path, "listing the meshes");
    BOOL more = 0;
    require(NMR::lib3mf_resourceiterator_movenext(objects.get(), &more), objects, path, "listing the meshes");
    if (more == 0) throw core::IoError(path.string(), "contains no mesh");
    require(NMR::lib3mf_resourceiterator_getcurrent(objects.get(), object.out()), objects, path, "taking the mesh");
    DWORD triangles = 0;
    require(NMR::lib3mf_meshobject_gettrianglecount(object.get(), &triangles), object, path, "counting triangles");
    require(NMR::lib3mf_meshobject_createpropertyhandler(object.get(), handler.out()), object, path, "reading colours");
    std::vector<NMR::MODELMESH_TRIANGLECOLOR_SRGB> found(triangles);
    require(NMR::lib3mf_propertyhandler_getcolorarray(handler.get(), found.data()), handler, path, "reading colours");
    std::vector<Colour> colours;
    for (const auto& t : found) colours.push_back({t.m_Colors[0].m_Red, t.m_Colors[0].m_Green, t.m_Colors[0].m_Blue});
    return colours;
}

}  // namespace fusee::exchange
