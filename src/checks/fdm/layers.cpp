#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_fdm_layers(const Design& design, const Allowed& allowed) {
    const double layer = process_limits(design.process).layer;
    if (design.process.kind != ProcessKind::kFdm || layer <= 0.0) return {};
    const double radius = design.part.options.groove.radius_ratio * design.cable.diameter;
    core::Finding f = compare(radius / layer, {allowed("review")});
    f.what = fmt::format("number of {:g} mm layers that make up the groove's floor, radius {:.3f} mm", mm_from_m(layer), mm_from_m(radius));
    f.where = along_groove(design);
    f.suggestion = change("process.layer_mm", down(mm_from_m(radius / f.allowed)));
    return {f};
}

}  // namespace

Rule fdm_layers() {
    return on_cable({"fdm.layers",
                     "a groove's floor printed as steps",
                     "FDM: layers in the radius of the groove's floor",
                     "two layers (practice)",
                     {review(kAtLeast, "layers", 2.0)},
                     measure_fdm_layers});
}

}  // namespace fusee::checks
