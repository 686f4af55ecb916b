#include "measure.h"

namespace fusee::inspect {

namespace {

/// The sample up to which the thinnest walls have this much area: a smaller spot is a scar, not a wall. nullptr: no wall.
const Sample* thinnest_of(const Body& body, double area_mm2) {
    std::vector<const Sample*> walls;
    for (const Sample& s : body.samples())
        if (!std::isnan(s.wall_mm)) walls.push_back(&s);
    std::stable_sort(walls.begin(), walls.end(), [](const Sample* a, const Sample* b) { return a->wall_mm < b->wall_mm; });
    double held = 0.0;
    for (const Sample* s : walls)
        if ((held += s->share_mm2) >= area_mm2) return s;
    return walls.empty() ? nullptr : walls.back();
}

std::optional<Marked> measure_mesh_wall(const Foreign& part, const Allowed& allowed) {
    const checks::ProcessLimits limits = checks::process_limits(part.process);
    const double wall = core::mm_from_m(limits.wall);
    const Sample* thinnest = thinnest_of(part.body, wall * wall);
    if (!thinnest) return std::nullopt;
    core::Finding f = compare(thinnest->wall_mm, {allowed("required", wall), allowed("review", core::mm_from_m(limits.loaded_wall))});
    f.what = f.severity == core::Severity::kWarning ? "thinnest wall, sufficient unless it carries load" : "thinnest wall";
    set_place(f, thinnest->at_mm);
    f.suggestion = fmt::format("{} mm thick there ({} mm more)", up(f.allowed), up(f.allowed - f.measured));
    return Marked{f, triangles_of(part.body, [&](const Sample& s) { return s.wall_mm < f.allowed; })};
}

}  // namespace

Rule mesh_wall() {
    return {{"mesh.wall",
             "a wall too thin to make",
             "least distance between two faces up to 30 deg off parallel, where a ball in the material touches both; none where these "
             "meet in an edge: mesh.feather_edge",
             "the process's walls: thin required, loaded recommended",
             {of_process(required(kAtLeast, "mm", "the process's wall")), of_process(review(kAtLeast, "mm", "the process's loaded wall"))}},
            measure_mesh_wall};
}

}  // namespace fusee::inspect
