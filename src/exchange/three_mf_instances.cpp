#include "three_mf_instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fusee/core/error.h"
#include "fusee/exchange/mesh_file.h"

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

}  // namespace

void require_few_instances(const Handle& model, const std::filesystem::path& path) {
    Counter counter(path);
    double sum = 0.0;
    for_each_item(model, path, [&](const Handle&, const Handle& object) { sum += counter.of(object, 0); });
    if (sum > static_cast<double>(kMostTriangles))
        throw core::IoError(path.string(),
                            fmt::format("contains {:.3g} triangles with its components; at most {} are read", sum, kMostTriangles));
}

}  // namespace fusee::exchange
