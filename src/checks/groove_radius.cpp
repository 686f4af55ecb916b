#include <fmt/format.h>

#include "fusee/core/units.h"
#include "measure.h"
#include "rules.h"

namespace fusee::checks {

namespace {

constexpr double kTightest = 0.5, kLow = 0.53, kHigh = 0.55;

core::Findings run(const Design& design) {
    const double ratio = design.part.options.groove.radius_ratio;
    core::Finding f = at_least(ratio, {kTightest, kLow}, "d");
    if (f.severity == core::Severity::kPass) f = at_most(ratio, {{}, kHigh}, "d");
    f.what =
        "radius of the groove's floor: " + std::string(f.bound == core::Bound::kAtLeast ? "pinches the cable" : "lets the cable flatten");
    if (f.severity == core::Severity::kPass) f.what = "radius of the groove's floor";
    f.suggestion = fmt::format("groove.radius_ratio = {:.2f} ({:.3f} mm)", f.severity == core::Severity::kRequired ? kLow : f.allowed,
                               core::mm_from_m((f.severity == core::Severity::kRequired ? kLow : f.allowed) * design.cable.diameter));
    return {f};
}

}  // namespace

Rule groove_radius() { return {"groove.radius", "a groove that pinches the cable or lets it flatten", "Unirope/Python: 0.53-0.55 d", run}; }

}  // namespace fusee::checks
