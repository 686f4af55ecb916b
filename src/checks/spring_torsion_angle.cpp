#include "measure.h"
#include "rules.h"
#include "spring_change.h"

namespace fusee::checks {

namespace {

core::Findings run(const Design& design) {
    if (design.spring.kind != spring::BaseKind::kTorsion || design.spring.max_state <= 0.0) return {};
    core::Finding f = at_most(largest_state(design), {design.spring.max_state, {}}, "rad");
    f.what = "largest winding of the base spring, preload counted";
    f.suggestion = limit_state(design, f.allowed);
    return {f};
}

}  // namespace

Rule spring_torsion_angle() { return {"spring.torsion_angle", "the torsion spring wound too far", "spring.max_angle_rad", run}; }

}  // namespace fusee::checks
