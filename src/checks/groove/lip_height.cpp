#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_groove_lip_height(const Design& design, const Allowed& allowed) {
    if (design.part.section.empty()) return {};
    const double d = design.cable.diameter, tolerance = process_limits(design.process).tolerance;
    core::Finding f = compare(mm_from_m(lip_offset(design.part) - 0.5 * d), {allowed("review", mm_from_m(tolerance))});
    f.what = "height of the lips above the outside of the cable";
    f.where = along_groove(design);
    f.suggestion = change("groove.depth_ratio", up(1.0 + m_from_mm(f.allowed) / d));
    return {f};
}

}  // namespace

Rule groove_lip_height() {
    return {"groove.lip_height",
            "lips that the process may make lower than the cable",
            "height of the lips above the outside of the cable",
            "the process's tolerance of a contour",
            {of_process(review(kAtLeast, "mm", "the process's tolerance"))},
            measure_groove_lip_height};
}

}  // namespace fusee::checks
