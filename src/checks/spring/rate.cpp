#include "means.h"
#include "spring_form.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_rate(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const double coils = spring::rate_of_coils(s);
    const char* unit = is_torsion(design) ? "Nm/rad" : "N/m";
    const double off = 100.0 * std::abs(coils / s.rate - 1.0);
    // A measured rate is true; only its coils may be stated wrongly.
    const bool measured = s.rate_origin == spring::RateOrigin::kMeasured;
    core::Finding f = measured ? compare(off, {allowed("measured_review")}) : compare(off, {allowed("required"), allowed("review")});
    f.what = fmt::format("{} rate {:.4g} {} against {:.4g} {} of {:g} mm wire, {:.4g} mm coils and {:.4g} turns",
                         measured ? "measured" : "stated", s.rate, unit, coils, unit, mm_from_m(s.wire_diameter),
                         mm_from_m(s.coil_diameter), s.active_coils);
    f.suggestion = form_for_rate(design);
    return {f};
}

}  // namespace

Rule spring_rate() {
    return {"spring.rate",
            "a rate that the stated wire, coils and turns do not have",
            "difference between the stated rate and G d^4/(8 D^3 n) (compression), E d^4/(64 D n) (torsion)",
            "EN 13906-1, EN 13906-3; error: Lee Spring's tolerance of rate and torque, 10 %; warning: half of it (practice); a measured "
            "rate is only reviewed",
            {required(kAtMost, "%", 10.0), review(kAtMost, "%", 5.0), review(kAtMost, "%", 10.0, "measured_review")},
            measure_spring_rate,
            nullptr,
            {need::kWire, need::kCoil, need::kActiveCoils}};
}

}  // namespace fusee::checks
