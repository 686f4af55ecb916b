#include "measure.h"

namespace fusee::inspect {

namespace {

std::optional<Marked> measure_mesh_hole_depth(const Foreign& part, const Allowed& allowed) {
    if (!is_milled(part.process) && part.process.kind != checks::ProcessKind::kSls) return std::nullopt;
    const bool powder = part.process.kind == checks::ProcessKind::kSls;
    std::optional<Hollow> deepest;
    for (const Hollow& h : part.body.hollows()) {
        if (!h.is_hole() || (powder && h.is_through())) continue;  // a through hole traps no powder
        if (!deepest || h.length_mm / h.diameter_mm > deepest->length_mm / deepest->diameter_mm) deepest = h;
    }
    if (!deepest) return std::nullopt;
    core::Finding f = powder ? compare(deepest->length_mm / deepest->diameter_mm, {allowed("powder_review")})
                             : compare(deepest->length_mm / deepest->diameter_mm, {allowed("required"), allowed("review")});
    f.what =
        fmt::format("depth of a {} hole of {:.2f} mm over its diameter", deepest->is_through() ? "through" : "blind", deepest->diameter_mm);
    set_place(f, deepest->middle_mm);
    f.suggestion = fmt::format("{} mm deep, or {} mm wide", down(f.allowed * deepest->diameter_mm), up(deepest->length_mm / f.allowed));
    return Marked{f, deepest->triangles};
}

}  // namespace

Rule mesh_hole_depth() {
    return {{"mesh.hole_depth",
             "a hole too deep to drill or to empty of powder",
             "milled: depth of the deepest cylindrical hole over its diameter; SLS: of the deepest blind one",
             "hole 4 diameters, at most 10: zekes3d, procurabl; powder 5 (practice)",
             {required(kAtMost, "diameters", 10.0), review(kAtMost, "diameters", 4.0), review(kAtMost, "diameters", 5.0, "powder_review")}},
            measure_mesh_hole_depth};
}

}  // namespace fusee::inspect
