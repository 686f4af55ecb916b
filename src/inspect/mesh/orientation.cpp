#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_orientation(const Foreign& part, const Allowed& allowed) {
    const Topology& topology = part.body.topology();
    std::vector<std::uint32_t> triangles = topology.flipped;
    std::size_t turned = 0;
    for (const bool t : part.body.turned()) turned += t ? 1 : 0;
    for (std::uint32_t t = 0; t < topology.component_of.size() && topology.flipped.empty(); ++t)
        if (part.body.turned()[topology.component_of[t]]) triangles.push_back(t);
    core::Finding f = compare(static_cast<double>(topology.flipped_edges + turned), {allowed("required")});
    f.what = fmt::format("{} edges whose two triangles face opposite sides, and {} bodies whose triangles face inward",
                         topology.flipped_edges, turned);
    if (!triangles.empty()) set_place(f, middle_of(part.body, triangles.front()));
    f.suggestion = fmt::format("{} triangles to turn: corners counter-clockwise seen from outside", triangles.size());
    return Marked{f, triangles};
}

}  // namespace

Rule mesh_orientation() {
    return {{"mesh.orientation",
             "triangles that face the wrong way",
             "edges along which both triangles run the same way, and closed bodies whose triangles face inward",
             "a solid has none",
             {required(kAtMost, "places", 0.0)}},
            measure_mesh_orientation};
}

}  // namespace fusee::inspect
