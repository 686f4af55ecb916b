#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kCoil = 0.0015, kWire = 0.1;  // of the standard's formula

core::Findings measure_spring_coil_gap(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const auto solid = spring::travel_to_solid(s);
    const double wire = mm_from_m(s.wire_diameter), coil = mm_from_m(s.coil_diameter);
    const double gaps = s.active_coils * (kCoil * coil * coil / wire + kWire * wire);
    core::Finding f = judge(mm_from_m(*solid - largest_state(design)), {allowed("review", gaps)});
    f.what = "remaining travel between the coils of the base spring at its largest compression";
    f.suggestion = change(design, "spring.free_length_mm", up(mm_from_m(s.free_length) + f.allowed - f.measured))
                       .or_else(limit_state(design, *solid - m_from_mm(f.allowed)));
    return {f};
}

}  // namespace

Rule spring_coil_gap() {
    return {"spring.coil_gap",
            "coils that clash before the spring is solid",
            "remaining travel to solid length at the largest compression",
            "EN 13906-1: n (0.0015 D^2/w + 0.1 w)",
            {review(kAtLeast, "mm", "n (0.0015 D^2/w + 0.1 w), lengths in mm")},
            measure_spring_coil_gap,
            is_compression,
            {need::kWire, need::kCoil, need::kActiveCoils, need::kFreeLength}};
}

}  // namespace fusee::checks
