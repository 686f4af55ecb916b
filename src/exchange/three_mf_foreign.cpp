#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "foreign.h"
#include "fusee/core/error.h"
#include "fusee/exchange/mesh_file.h"
#include "lib3mf.h"

namespace fusee::exchange {

namespace {

constexpr int kDeepest = 100;

class Counter {
public:
    explicit Counter(const std::filesystem::path& path) : path_(path) {}

    /// The larger of the counts of triangles and meshes of the object with all its components; a double, so that it cannot overflow.
    double of(const Handle& object, int depth) {
        if (depth > kDeepest) throw core::IoError(path_.string(), fmt::format("contains components nested more than {} deep", kDeepest));
        DWORD id = 0;
        require(NMR::lib3mf_resource_getresourceid(object.get(), &id), object, path_, "reading an object's number");
        if (const auto known = counts_.find(id); known != counts_.end()) return known->second;
        BOOL composed = 0;
        require(NMR::lib3mf_object_iscomponentsobject(object.get(), &composed), object, path_, "reading an object's kind");
        return counts_[id] = composed != 0 ? of_components(object, depth) : of_mesh(object);
    }

private:
    double of_mesh(const Handle& object) const {
        DWORD triangles = 0;
        require(NMR::lib3mf_meshobject_gettrianglecount(object.get(), &triangles), object, path_, "counting triangles");
        return std::max(1.0, static_cast<double>(triangles));
    }
    double of_components(const Handle& object, int depth) {
        DWORD count = 0;
        require(NMR::lib3mf_componentsobject_getcomponentcount(object.get(), &count), object, path_, "counting components");
        double sum = 0.0;
        for (DWORD i = 0; i < count; ++i) {
            Handle component, part;
            require(NMR::lib3mf_componentsobject_getcomponent(object.get(), i, component.out()), object, path_, "taking a component");
            require(NMR::lib3mf_component_getobjectresource(component.get(), part.out()), component, path_, "taking a component's object");
            sum += of(part, depth + 1);
        }
        return sum;
    }

    const std::filesystem::path& path_;
    std::map<DWORD, double> counts_;  ///< by the number of the object
};

/// Counts the triangles of all build items with their components before lib3mf copies them: nested components multiply.
/// @throws core::IoError naming the file: more than kMostTriangles, or components nested deeper than 100
void require_few_instances(const Handle& model, const std::filesystem::path& path) {
    Counter counter(path);
    double sum = 0.0;
    for_each_item(model, path, [&](const Handle&, const Handle& object) { sum += counter.of(object, 0); });
    if (sum > static_cast<double>(kMostTriangles))
        throw core::IoError(path.string(),
                            fmt::format("contains {:.3g} triangles with its components; at most {} are read", sum, kMostTriangles));
}

struct Unit {
    const char* name;
    double mm;
};
/// The units in the order of lib3mf's numbers.
constexpr std::array kUnits = {Unit{"micrometre", 1e-3}, Unit{"millimetre", 1.0}, Unit{"centimetre", 10.0},
                               Unit{"inch", 25.4},       Unit{"foot", 304.8},     Unit{"metre", 1000.0}};

/// x' = the first three columns times x, plus the fourth.
using Placement = std::array<std::array<double, 4>, 3>;
constexpr Placement kInPlace = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

Placement placement_of(const NMR::MODELTRANSFORM& transform) {
    Placement p{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 4; ++k) p[i][k] = transform.m_fFields[i][k];
    return p;
}

/// First `inner`, then `outer`.
Placement after(const Placement& outer, const Placement& inner) {
    Placement both{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 4; ++k) {
            both[i][k] = k == 3 ? outer[i][3] : 0.0;
            for (std::size_t j = 0; j < 3; ++j) both[i][k] += outer[i][j] * inner[j][k];
        }
    return both;
}

bool mirrors(const Placement& p) {
    return p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) - p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
               p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]) <
           0.0;
}

/// Appends every mesh of an object, placed; components may be nested. @pre require_few_instances
void append_object(solid::Mesh& to, const Handle& object, const Placement& at, double scale, const std::filesystem::path& path) {
    BOOL composed = 0;
    require(NMR::lib3mf_object_iscomponentsobject(object.get(), &composed), object, path, "reading an object's kind");
    if (composed == 0) {
        const solid::Mesh mesh = take_mesh(object, path);
        const auto first = static_cast<std::uint32_t>(to.points_mm.size());
        for (const solid::Vec3& p : mesh.points_mm) {
            solid::Vec3& q = to.points_mm.emplace_back();
            for (std::size_t i = 0; i < 3; ++i) q[i] = scale * (at[i][0] * p[0] + at[i][1] * p[1] + at[i][2] * p[2] + at[i][3]);
        }
        const bool turned = mirrors(at);  // else its inside would be outside
        for (const solid::Triangle& t : mesh.triangles)
            to.triangles.push_back({first + t[0], first + t[turned ? 2 : 1], first + t[turned ? 1 : 2]});
        return;
    }
    DWORD count = 0;
    require(NMR::lib3mf_componentsobject_getcomponentcount(object.get(), &count), object, path, "counting components");
    for (DWORD i = 0; i < count; ++i) {
        Handle component, part;
        NMR::MODELTRANSFORM transform{};
        require(NMR::lib3mf_componentsobject_getcomponent(object.get(), i, component.out()), object, path, "taking a component");
        require(NMR::lib3mf_component_gettransform(component.get(), &transform), component, path, "reading a transform");
        require(NMR::lib3mf_component_getobjectresource(component.get(), part.out()), component, path, "taking a component's object");
        append_object(to, part, after(at, placement_of(transform)), scale, path);
    }
}

}  // namespace

MeshFile read_foreign_3mf(std::string bytes, const std::filesystem::path& path) {
    const std::scoped_lock lock(library_mutex());
    Handle model;
    read_model(model, std::move(bytes), path);
    DWORD unit = 0;
    require(NMR::lib3mf_model_getunit(model.get(), &unit), model, path, "reading the unit");
    if (unit >= kUnits.size()) throw core::IoError(path.string(), "has an unknown unit");
    require_few_instances(model, path);
    MeshFile file{{}, kUnits[unit].name};
    for_each_item(model, path, [&](const Handle& item, const Handle& object) {
        BOOL placed = 0;
        NMR::MODELTRANSFORM transform{};
        require(NMR::lib3mf_builditem_hasobjecttransform(item.get(), &placed), item, path, "reading a transform");
        if (placed != 0) require(NMR::lib3mf_builditem_getobjecttransform(item.get(), &transform), item, path, "reading a transform");
        const std::size_t before = file.mesh.triangles.size();
        append_object(file.mesh, object, placed != 0 ? placement_of(transform) : kInPlace, kUnits[unit].mm, path);
        file.items.push_back({name_of(object, path), file.mesh.triangles.size() - before});
    });
    return file;
}

}  // namespace fusee::exchange
