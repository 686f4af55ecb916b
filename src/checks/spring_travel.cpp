#include <fmt/format.h>

#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"
#include "spring_change.h"

namespace fusee::checks {

namespace {

constexpr double kDeadCoils = 2.0;              // ground ends: one coil each that does not work
constexpr double kReview = 0.80, kMost = 0.85;  // of the travel to solid; beyond, coils touch and the rate rises

core::Finding against(const Design& design, const Limits& limits, const std::string& what) {
    core::Finding f = at_most(core::mm_from_m(largest_state(design)), limits, "mm");
    f.what = what;
    f.suggestion = limit_state(design, core::m_from_mm(f.allowed));
    return f;
}

core::Findings run(const Design& design) {
    const spring::BaseSpring& s = design.spring;
    if (s.kind != spring::BaseKind::kCompression) return {};
    core::Findings findings;
    if (s.max_state > 0.0) {
        findings.push_back(against(design, {core::mm_from_m(s.max_state), {}}, "largest compression of the base spring, preload counted"));
        findings.back().source = "spring.max_travel_mm";
    }
    if (s.free_length > 0.0 && s.active_coils > 0.0 && s.wire_diameter > 0.0) {
        const double solid = s.free_length - (s.active_coils + kDeadCoils) * s.wire_diameter;
        findings.push_back(
            against(design, {core::mm_from_m(kMost * solid), core::mm_from_m(kReview * solid)},
                    fmt::format("largest compression of the base spring, of {:.2f} mm to solid length", core::mm_from_m(solid))));
    }
    return findings;
}

}  // namespace

Rule spring_travel() {
    return {"spring.travel", "the compression spring going solid", "80-85 % of the travel to solid length (practice)", run};
}

}  // namespace fusee::checks
