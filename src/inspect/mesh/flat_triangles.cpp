#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_flat_triangles(const Foreign& part, const Allowed& allowed) {
    const std::vector<std::uint32_t> flat = flat_triangles(part.body.mesh());
    core::Finding f = compare(static_cast<double>(flat.size()), {allowed("review")});
    f.what = "triangles without area: some readers drop them and leave a hole";
    if (!flat.empty()) set_place(f, middle_of(part.body, flat.front()));
    f.suggestion = fmt::format("{} triangles collapsed in the program that drew them", flat.size());
    return Marked{f, flat};
}

}  // namespace

Rule mesh_flat_triangles() {
    return {{"mesh.flat_triangles",
             "triangles that a reader may drop",
             "triangles whose height is below 1e-9 of their longest edge",
             "none (practice)",
             {review(kAtMost, "triangles", 0.0)}},
            measure_mesh_flat_triangles};
}

}  // namespace fusee::inspect
