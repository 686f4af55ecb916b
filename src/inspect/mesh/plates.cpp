#include <numeric>

#include "measure.h"

namespace fusee::inspect {

namespace {

constexpr double kDraft = core::rad_from_deg(2.0);  // a cut's own draft, and facets

std::optional<Marked> measure_mesh_plates(const Foreign& part, const Allowed& allowed) {
    if (!is_stacked(part.process)) return std::nullopt;
    const Body& body = part.body;
    double inclined = 0.0;
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t t = 0; t < body.mesh().triangles.size(); ++t) {
        const double z = std::abs(body.normals()[t][2]);
        if (z < std::sin(kDraft) || z > std::cos(kDraft)) continue;
        inclined += body.areas_mm2()[t];
        triangles.push_back(t);
    }
    const double whole = std::accumulate(body.areas_mm2().begin(), body.areas_mm2().end(), 0.0);
    core::Finding f = compare(100.0 * inclined / whole, {allowed("required")});
    f.what = fmt::format("share of the surface that is neither horizontal nor vertical, which plates cut along z cannot have: {:.3g} mm^2",
                         inclined);
    if (!triangles.empty()) set_place(f, middle_of(body, triangles.front()));
    f.suggestion = fmt::format("{} mm^2 drawn as steps of the plates' thickness", up(inclined));
    return Marked{f, triangles};
}

}  // namespace

Rule mesh_plates() {
    return {{"mesh.plates",
             "a shape that is not a stack of plates",
             "wire, laser: share of the surface at more than 2 deg from horizontal and vertical",
             "1 % for chamfers and marks (practice)",
             {required(kAtMost, "%", 1.0)}},
            measure_mesh_plates};
}

}  // namespace fusee::inspect
