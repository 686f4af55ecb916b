#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_sls_groove(const Design& design, const Allowed& allowed) {
    if (design.process.kind != ProcessKind::kSls || design.part.section.size() < 2) return {};
    const double width = 2.0 * half_width_at_cable(design.part);
    core::Finding f = compare(mm_from_m(width), {allowed("review")});
    f.what = "width of the groove at the height of the cable's centreline";
    f.where = along_groove(design);
    f.suggestion = change("cable.diameter_mm", up(mm_from_m(design.cable.diameter) * f.allowed / f.measured));
    return {f};
}

}  // namespace

Rule sls_groove() {
    return on_cable({"sls.groove",
                     "a groove that sintered powder closes",
                     "SLS: width of the groove at the cable's height",
                     "clearance 0.2-0.5 mm: 3dservicesusa, cifproto, arti90, layerx3d",
                     {review(kAtLeast, "mm", 0.5)},
                     measure_sls_groove});
}

}  // namespace fusee::checks
