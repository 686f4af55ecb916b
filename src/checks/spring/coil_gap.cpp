#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_coil_gap(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const auto solid = spring::travel_to_solid(s);
    core::Finding f = compare(mm_from_m(*solid - largest_state(design)), {allowed("review", mm_from_m(spring::least_gaps(s)))});
    f.what = fmt::format("remaining travel between the coils of the base spring at its largest compression, under a {} load",
                         spring::is_dynamic(s) ? "changing" : "rarely changing");
    f.suggestion = change(design, "spring.free_length_mm", up(mm_from_m(s.free_length) + f.allowed - f.measured))
                       .or_else(limit_state(design, *solid - m_from_mm(f.allowed)));
    return {f};
}

}  // namespace

Rule spring_coil_gap() {
    return {"spring.coil_gap",
            "coils that clash before the spring is solid",
            "remaining travel to solid length at the largest compression",
            "EN 13906-1: n (0.0015 D^2/w + 0.1 w), half as much more for a changing load of a cold formed spring (febrotec)",
            {review(kAtLeast, "mm", "n (0.0015 D^2/w + 0.1 w), lengths in mm; 1.5 times that from spring.cycles = 10 000 on")},
            measure_spring_coil_gap,
            is_compression,
            {need::kWire, need::kCoil, need::kActiveCoils, need::kFreeLength}};
}

}  // namespace fusee::checks
