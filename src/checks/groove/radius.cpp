#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kGood = 0.53;  // [d]

core::Findings measure_groove_radius(const Design& design, const Allowed& allowed) {
    if (is_stacked(design)) return {};  // a plate's edge is flat: stack.groove_width
    const double ratio = design.part.options.groove.radius_ratio;
    core::Finding f = compare(ratio, {allowed("required"), allowed("low_review"), allowed("high_review")});
    f.what =
        "radius of the groove's floor: " + std::string(f.bound == core::Bound::kAtLeast ? "pinches the cable" : "lets the cable flatten");
    if (f.severity == core::Severity::kPass) f.what = "radius of the groove's floor";
    const double better = f.severity == core::Severity::kError ? kGood : f.allowed;
    f.suggestion = change("groove.radius_ratio", fmt::format("{:.2f}", better))
                       .noted(fmt::format(" ({:.3f} mm)", mm_from_m(better * design.cable.diameter)));
    return {f};
}

}  // namespace

Rule groove_radius() {
    return {"groove.radius",
            "a groove that pinches the cable or lets it flatten",
            "floor radius",
            "Unirope/Python: 0.53-0.55 d",
            {required(kAtLeast, "d", 0.5), review(kAtLeast, "d", kGood, "low_review"), review(kAtMost, "d", 0.55, "high_review")},
            measure_groove_radius};
}

}  // namespace fusee::checks
