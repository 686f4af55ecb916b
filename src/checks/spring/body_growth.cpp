#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_body_growth(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const auto space = allowed.stated("required", mm_from_m(s.free_length));
    const double turns = largest_state(design) / (2.0 * core::kPi);
    core::Finding f = compare(mm_from_m(spring::wound_length(s, largest_state(design))), {*space});
    f.what = fmt::format("length of the base spring's body when it is wound by {:.2f} turns", turns);
    f.suggestion = change(design, "spring.free_length_mm", up(f.measured));
    return {f};
}

}  // namespace

Rule spring_body_growth() {
    return {"spring.body_growth",
            "a torsion spring that grows longer than its space",
            "length of the wound body, w (N + 1 + turns)",
            "Newcomb: the body grows by a wire each turn",
            {required(kAtMost, "mm", "spring.free_length_mm, the space along the axis; not judged without it")},
            measure_spring_body_growth,
            is_torsion,
            {need::kActiveCoils, need::kWire, need::kAxialSpace}};
}

}  // namespace fusee::checks
