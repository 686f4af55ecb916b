#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_feather_edge(const Foreign& part, const Allowed& allowed) {
    const double thin = core::mm_from_m(checks::process_limits(part.process).wall);
    const auto counts = [thin](const Sample& s) { return s.edge && s.edge->width_mm < thin; };
    const Sample* sharpest = nullptr;
    for (const Sample& s : part.body.samples())
        if (counts(s) && (!sharpest || s.edge->angle < sharpest->edge->angle)) sharpest = &s;
    if (!sharpest) return std::nullopt;
    core::Finding f = compare(core::deg_from_rad(sharpest->edge->angle), {allowed("review")});
    f.what = fmt::format("angle of the sharpest edge, {:.2f} mm thick {:.2f} mm from it", sharpest->edge->width_mm, sharpest->edge->way_mm);
    set_place(f, sharpest->at_mm);
    f.suggestion = fmt::format("edge cut off at a thickness of {:g} mm, or opened to {} deg", thin, up(f.allowed));
    return Marked{f, triangles_of(part.body, counts)};
}

}  // namespace

Rule mesh_feather_edge() {
    return {{"mesh.feather_edge",
             "a knife edge that chips, cuts or cannot be made",
             "angle between two faces that meet in an edge, where the material is thinner than the process's wall",
             "30 deg (practice)",
             {review(kAtLeast, "deg", 30.0)}},
            measure_mesh_feather_edge};
}

}  // namespace fusee::inspect
