#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_closed(const Foreign& part, const Allowed& allowed) {
    const Topology& topology = part.body.topology();
    core::Finding f = compare(static_cast<double>(topology.open_edges), {allowed("required")});
    f.what = "edges of one triangle only: the surface has holes and no inside";
    if (!topology.open.empty()) set_place(f, middle_of(part.body, topology.open.front()));
    f.suggestion = fmt::format("the {} triangles along the gap stitched or capped in the program that drew them", topology.open.size());
    return Marked{f, topology.open};
}

}  // namespace

Rule mesh_closed() {
    return {{"mesh.closed",
             "a surface with holes in it",
             "edges that belong to one triangle only",
             "a solid has none",
             {required(kAtMost, "edges", 0.0)}},
            measure_mesh_closed};
}

}  // namespace fusee::inspect
