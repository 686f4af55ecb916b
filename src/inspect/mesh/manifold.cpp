#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_manifold(const Foreign& part, const Allowed& allowed) {
    const Topology& topology = part.body.topology();
    core::Finding f = compare(static_cast<double>(topology.crowded_edges + topology.pinched_points), {allowed("required")});
    f.what = fmt::format("{} edges of more than two triangles and {} points at which surfaces meet without an edge", topology.crowded_edges,
                         topology.pinched_points);
    std::vector<std::uint32_t> triangles = topology.crowded;
    if (triangles.empty()) triangles = topology.pinched;
    if (!triangles.empty()) set_place(f, middle_of(part.body, triangles.front()));
    f.suggestion =
        fmt::format("bodies that touch there joined or moved apart by {:g} mm", core::mm_from_m(checks::process_limits(part.process).wall));
    return Marked{f, triangles};
}

}  // namespace

Rule mesh_manifold() {
    return {{"mesh.manifold",
             "a surface that touches itself in an edge or a point",
             "edges of more than two triangles, and points at which fans of triangles meet without an edge",
             "a solid has none",
             {required(kAtMost, "places", 0.0)}},
            measure_mesh_manifold};
}

}  // namespace fusee::inspect
