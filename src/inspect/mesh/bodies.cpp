#include <fmt/format.h>

#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_bodies(const Foreign& part, const Allowed& allowed) {
    const Topology& topology = part.body.topology();
    std::size_t bodies = 0, largest = 0;
    for (std::size_t c = 0; c < topology.components.size(); ++c) {
        if (part.body.cavity()[c]) continue;
        ++bodies;
        if (part.body.cavity()[largest] || std::abs(topology.components[c].volume_mm3) > std::abs(topology.components[largest].volume_mm3))
            largest = c;
    }
    std::vector<std::uint32_t> others;
    for (std::uint32_t t = 0; t < topology.component_of.size(); ++t)
        if (topology.component_of[t] != largest && !part.body.cavity()[topology.component_of[t]]) others.push_back(t);
    core::Finding f = judge(static_cast<double>(bodies), {allowed("review")});
    f.what = "separate bodies";
    if (!others.empty()) set_place(f, middle_of(part.body, others.front()));
    f.suggestion = fmt::format("each of the {} bodies in a file of its own, or joined", bodies);
    return Marked{f, others};
}

}  // namespace

Rule mesh_bodies() {
    return {{"mesh.bodies",
             "several bodies, or loose fragments, in one file",
             "surfaces that share no edge, cavities not counted",
             "one part per file (practice)",
             {review(kAtMost, "bodies", 1.0)}},
            measure_mesh_bodies};
}

}  // namespace fusee::inspect
