#include "measure.h"
#include "rules.h"
#include "spring_change.h"

namespace fusee::checks {

namespace {

core::Findings run(const Design& design) {
    if (design.spring.max_load <= 0.0) return {};
    const bool torsion = design.spring.kind == spring::BaseKind::kTorsion;
    core::Finding f = at_most(design.spring.rate * largest_state(design), {design.spring.max_load, {}}, torsion ? "Nm" : "N");
    f.what = torsion ? "largest torque of the base spring" : "largest force of the base spring";
    f.suggestion = limit_load(design, f.allowed);
    return {f};
}

}  // namespace

Rule spring_load() { return {"spring.load", "the base spring loaded beyond its rating", "spring.max_torque_Nm, spring.max_force_N", run}; }

}  // namespace fusee::checks
