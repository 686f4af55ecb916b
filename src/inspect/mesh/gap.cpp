#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_gap(const Foreign& part, const Allowed& allowed) {
    const double detail = core::mm_from_m(checks::process_limits(part.process).detail);
    const auto least = allowed.stated("review", detail);
    if (!least) return std::nullopt;
    const Sample* narrowest = nullptr;
    for (const Sample& s : part.body.samples())
        if (!std::isnan(s.gap_mm) && (!narrowest || s.gap_mm < narrowest->gap_mm)) narrowest = &s;
    if (!narrowest) return std::nullopt;
    core::Finding f = compare(narrowest->gap_mm, {*least});
    f.what = "narrowest slot";
    set_place(f, narrowest->at_mm);
    f.suggestion = fmt::format("{} mm wide there ({} mm more)", up(f.allowed), up(f.allowed - f.measured));
    return Marked{f, triangles_of(part.body, [&](const Sample& s) { return s.gap_mm < f.allowed; })};
}

}  // namespace

Rule mesh_gap() {
    return {{"mesh.gap",
             "a slot too narrow to make or to keep open",
             "least distance between two faces up to 30 deg off parallel, where a ball outside the material touches both",
             "the process's least detail",
             {of_process(review(kAtLeast, "mm", "the process's detail; none for plates"))}},
            measure_mesh_gap};
}

}  // namespace fusee::inspect
