#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_process_detail(const Design& design, const Allowed& allowed) {
    const solid::FeatureOptions& features = design.part.options.features;
    const double detail = mm_from_m(process_limits(design.process).detail);
    const bool slot = has_slot(features) && (features.mark_width <= 0.0 || features.leg_slot_width < features.mark_width);
    const double narrowest = slot ? features.leg_slot_width : features.mark_width;
    const auto least = allowed.stated("review", detail);
    if (!least || narrowest <= 0.0) return {};
    core::Finding f = compare(mm_from_m(narrowest), {*least});
    f.what = fmt::format("width of the {}", slot ? "spring leg's slot" : "timing mark");
    f.suggestion = change(design, slot ? "features.leg_slot_width_mm" : "features.mark_width_mm", up(f.allowed));
    return {f};
}

}  // namespace

Rule process_detail() {
    return {"process.detail",
            "a slot or mark too narrow for the process",
            "narrowest of timing mark and spring leg's slot",
            "the process's least detail",
            {of_process(review(kAtLeast, "mm", "the process's detail; none for plates"))},
            measure_process_detail};
}

}  // namespace fusee::checks
