#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_cavity(const Foreign& part, const Allowed& allowed) {
    if (part.process.kind == checks::ProcessKind::kFdm) return std::nullopt;  // FDM can print closed cavities
    const Topology& topology = part.body.topology();
    double volume = 0.0;
    for (std::size_t c = 0; c < topology.components.size(); ++c)
        if (part.body.cavity()[c]) volume -= topology.components[c].volume_mm3;
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t t = 0; t < topology.component_of.size(); ++t)
        if (part.body.cavity()[topology.component_of[t]]) triangles.push_back(t);
    core::Finding f = compare(volume, {allowed("required")});
    f.what = is_printed(part.process) ? "closed cavity: unhardened material cannot leave it" : "closed cavity, which no tool can reach";
    if (!triangles.empty()) set_place(f, middle_of(part.body, triangles.front()));
    f.suggestion =
        fmt::format("two openings of at least {:g} mm, or no cavity", core::mm_from_m(checks::process_limits(part.process).hole));
    return Marked{f, triangles};
}

}  // namespace

Rule mesh_cavity() {
    return {{"mesh.cavity",
             "a cavity that is closed on all sides",
             "all except FDM: volume of the cavities inside the material",
             "resin and powder must leave, a tool must enter (practice)",
             {required(kAtMost, "mm^3", 0.0)}},
            measure_mesh_cavity};
}

}  // namespace fusee::inspect
