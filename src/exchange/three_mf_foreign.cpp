#include <array>

#include "foreign.h"
#include "fusee/core/error.h"
#include "lib3mf.h"
#include "three_mf_instances.h"

namespace fusee::exchange {

namespace {

struct Unit {
    const char* name;
    double mm;
};
/// In the order of lib3mf's numbers.
constexpr std::array kUnits = {Unit{"micrometre", 1e-3}, Unit{"millimetre", 1.0}, Unit{"centimetre", 10.0},
                               Unit{"inch", 25.4},       Unit{"foot", 304.8},     Unit{"metre", 1000.0}};

void append_scaled(solid::Mesh& to, const solid::Mesh& more, double scale) {
    const auto first = static_cast<std::uint32_t>(to.points_mm.size());
    for (const solid::Vec3& p : more.points_mm) to.points_mm.push_back({scale * p[0], scale * p[1], scale * p[2]});
    for (const solid::Triangle& t : more.triangles) to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

}  // namespace

MeshFile read_foreign_3mf(std::string bytes, const std::filesystem::path& path) {
    const std::scoped_lock lock(library_mutex());
    Handle model, reader, merged, objects;
    require(NMR::lib3mf_createmodel(model.out()), model, path, "creating the model");
    require(NMR::lib3mf_model_queryreader(model.get(), "3mf", reader.out()), model, path, "making the reader");
    require(NMR::lib3mf_reader_readfrombuffer(reader.get(), reinterpret_cast<BYTE*>(bytes.data()), bytes.size()), reader, path, "reading");
    DWORD unit = 0;
    require(NMR::lib3mf_model_getunit(model.get(), &unit), model, path, "reading the unit");
    if (unit >= kUnits.size()) throw core::IoError(path.string(), "has an unknown unit");
    require_few_instances(model, path);
    require(NMR::lib3mf_model_mergetomodel(model.get(), merged.out()), model, path, "placing components");
    require(NMR::lib3mf_model_getmeshobjects(merged.get(), objects.out()), merged, path, "listing the meshes");
    MeshFile file{{}, kUnits[unit].name};
    BOOL more = 0;
    for (require(NMR::lib3mf_resourceiterator_movenext(objects.get(), &more), objects, path, "listing the meshes"); more != 0;
         require(NMR::lib3mf_resourceiterator_movenext(objects.get(), &more), objects, path, "listing the meshes")) {
        Handle object;
        require(NMR::lib3mf_resourceiterator_getcurrent(objects.get(), object.out()), objects, path, "taking a mesh");
        append_scaled(file.mesh, take_mesh(object, path), kUnits[unit].mm);
    }
    return file;
}

}  // namespace fusee::exchange
