#include "means.h"

namespace fusee::checks {

namespace {

constexpr double kYoung = 207e9, kShear = 79.3e9;  // spring steel [Pa]
constexpr double kC1 = kYoung / (2.0 * (kYoung - kShear));
constexpr double kC2 = 2.0 * core::kPi * core::kPi * (kYoung - kShear) / (2.0 * kShear + kYoung);

/// alpha: both ends on the pins of a follower's arm, or on flat parallel plates.
double ends(const Design& design) { return is_on_arm(design) ? 1.0 : 0.5; }

/// Free length below which the spring is stable at every compression: lambda^2 = C2, that is 5.25 D between plates.
double stable_length(const Design& design) { return std::sqrt(kC2) * design.spring.coil_diameter / ends(design); }

/// y_cr = L0 C1 (1 - sqrt(1 - C2/lambda^2)), lambda = alpha L0/D. @pre longer than stable_length
double critical_compression(const Design& design) {
    const spring::BaseSpring& s = design.spring;
    const double slenderness = ends(design) * s.free_length / s.coil_diameter;
    return s.free_length * kC1 * (1.0 - std::sqrt(1.0 - kC2 / (slenderness * slenderness)));
}

/// A shorter spring where its travel still fits in; a guide in any case. The cable runs through the coils, so that a rod is a tube.
core::Suggestion change_of(const Design& design) {
    const spring::BaseSpring& s = design.spring;
    const double stable = mm_from_m(stable_length(design)), outside = mm_from_m(s.coil_diameter + s.wire_diameter);
    const auto travel = spring::travel_to_solid(s);
    const double solid = travel ? mm_from_m(s.free_length - *travel) : 0.0, least = solid + mm_from_m(largest_state(design));
    const std::string guide =
        s.rod_diameter > 0.0
            ? fmt::format("the stated rod of {:g} mm as a tube around the cable, over the whole spring", mm_from_m(s.rod_diameter))
            : std::string("a guide tube inside, around the cable, over the whole spring");
    const std::string guides = fmt::format("{}, or a sleeve of more than {:.3g} mm around the coils", guide, outside);
    if (least > stable)
        return fmt::format("{}; no shorter spring: stable below {:.1f} mm, but its turns and travel need {:.1f} mm", guides, stable, least);
    return change(design, "spring.free_length_mm", down(stable)).or_else(guides);
}

core::Findings measure_spring_buckling(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    core::Finding f;
    if (s.free_length <= stable_length(design)) {
        f = compare(mm_from_m(s.free_length), {allowed("length_review", mm_from_m(stable_length(design)))});
        f.what = "free length of the base spring: stable at every compression";
        return {f};
    }
    f = compare(mm_from_m(largest_state(design)), {allowed("review", mm_from_m(critical_compression(design)))});
    f.what = fmt::format("largest compression of the slender base spring, against its buckling compression {}",
                         is_on_arm(design) ? "on two pins" : "between flat plates");
    f.suggestion = change_of(design);
    return {f};
}

}  // namespace

Rule spring_buckling() {
    return {
        "spring.buckling",
        "the compression spring buckling",
        "free length, or largest compression if longer than 5.25 D",
        "roymech, machinecalcs: stable below 5.25 D on flat plates",
        {review(kAtMost, "mm", "5.25 D", "length_review"), review(kAtMost, "mm", "L0 C1 (1 - sqrt(1 - C2/lambda^2)), lambda = L0/(2 D)")},
        measure_spring_buckling,
        is_compression,
        {need::kFreeLength, need::kCoil}};
}

}  // namespace fusee::checks
