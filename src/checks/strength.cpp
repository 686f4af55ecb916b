#include "strength.h"

#include <fmt/format.h>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"

namespace fusee::checks {

BreakingLoad breaking_load(const Cable& cable) {
    if (cable.breaking_load > 0.0) return {cable.breaking_load, false};
    return {usual_cable(cable.construction, cable.diameter), true};
}

std::string BreakingLoad::remark(const Cable& cable) const {
    if (!estimated) return "";
    return fmt::format("; no breaking load is stated: {:.0f} N is an estimate for {:.3g} mm of {}", newton, core::mm_from_m(cable.diameter),
                       cable.construction);
}

}  // namespace fusee::checks
