#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_load(const Design& design, const Allowed& allowed) {
    const bool torsion = design.spring.kind == spring::BaseKind::kTorsion;
    const auto most = allowed.stated(torsion ? "torque_required" : "force_required", design.spring.max_load);
    core::Finding f = compare(design.spring.rate * largest_state(design), {*most});
    f.what = torsion ? "largest torque of the base spring" : "largest force of the base spring";
    f.suggestion = limit_load(design, f.allowed);
    return {f};
}

}  // namespace

Rule spring_load() {
    return {"spring.load",
            "the base spring loaded beyond its rating",
            "rate x largest state",
            "spring.max_torque_Nm, spring.max_force_N",
            {required(kAtMost, "Nm", "spring.max_torque_Nm; not judged without it", "torque_required"),
             required(kAtMost, "N", "spring.max_force_N; not judged without it", "force_required")},
            measure_spring_load,
            nullptr,
            {need::kMaxTorque, need::kMaxForce}};
}

}  // namespace fusee::checks
