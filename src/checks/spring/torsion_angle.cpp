#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_torsion_angle(const Design& design, const Allowed& allowed) {
    const auto most = allowed.stated("required", design.spring.max_state);
    core::Finding f = compare(largest_state(design), {*most});
    f.what = "largest winding of the base spring, preload included";
    f.suggestion = limit_state(design, f.allowed);
    return {f};
}

}  // namespace

Rule spring_torsion_angle() {
    return {"spring.torsion_angle",
            "the torsion spring wound too far",
            "largest winding, preload included",
            "spring.max_angle_rad",
            {required(kAtMost, "rad", "spring.max_angle_rad; not judged without it")},
            measure_spring_torsion_angle,
            is_torsion,
            {need::kMaxAngle}};
}

}  // namespace fusee::checks
