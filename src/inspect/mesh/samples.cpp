#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_samples(const Foreign& part, const Allowed& allowed) {
    const Body& body = part.body;
    const std::size_t left_out = body.samples_left_out() + body.components_left_out();
    if (left_out == 0) {
        core::Finding f = compare(0.0, {allowed("required")});
        f.what = "points that were left out";
        return Marked{f};
    }
    core::Finding f =
        core::not_judged("mesh.samples",
                         fmt::format("{} of {} points and {} components were left out, because too many triangles overlap; "
                                     "walls, slots, holes and undercuts there are not known",
                                     body.samples_left_out(), body.samples_left_out() + body.samples().size(), body.components_left_out()),
                         "a mesh whose triangles do not overlap");
    return Marked{f};
}

}  // namespace

Rule mesh_samples() {
    return {{"mesh.samples",
             "walls and slots that were not measured",
             "points left out because measuring them would visit more than 8e8 triangles in all, or 2e8 where triangles overlap",
             "a point that is not measured is not judged",
             {required(kAtMost, "places", 0.0)}},
            measure_mesh_samples};
}

}  // namespace fusee::inspect
