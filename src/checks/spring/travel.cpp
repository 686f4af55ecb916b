#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kReview = 0.80, kMost = 0.85;  // of the travel to solid; beyond, coils touch and the rate rises

core::Finding against(const Design& design, std::initializer_list<EffectiveLimit> limits, const std::string& what) {
    core::Finding f = compare(mm_from_m(largest_state(design)), limits);
    f.what = what;
    f.suggestion = limit_state(design, m_from_mm(f.allowed));
    return f;
}

core::Findings measure_spring_travel(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    core::Findings findings;
    if (const auto most = allowed.stated("rated_required", mm_from_m(s.max_state))) {
        findings.push_back(against(design, {*most}, "largest compression of the base spring, preload included"));
        findings.back().source = "spring.max_travel_mm";
    }
    if (const auto travel = spring::travel_to_solid(s)) {
        const double solid = mm_from_m(*travel);
        findings.push_back(against(design, {allowed("required", kMost * solid), allowed("review", kReview * solid)},
                                   fmt::format("largest compression of the base spring, of {:.2f} mm to solid length", solid)));
    }
    return findings;
}

}  // namespace

Rule spring_travel() {
    return {"spring.travel",
            "the compression spring compressed to its solid length",
            "largest compression, preload included",
            "80-85 % of the travel to solid length (practice)",
            {required(kAtMost, "mm", "spring.max_travel_mm; not judged without it", "rated_required"),
             required(kAtMost, "mm", "85 % of free length - (active coils + 2) wire"), review(kAtMost, "mm", "80 % of it")},
            measure_spring_travel,
            is_compression,
            {need::kTravel}};
}

}  // namespace fusee::checks
