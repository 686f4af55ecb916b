#pragma once
#include <string>

#include "fusee/checks/check.h"

namespace fusee::checks {

/// The cable's breaking load: as the profile states it, else estimated by construction and diameter.
struct BreakingLoad {
    double newton = 0.0;
    bool estimated = false;
    /// "", or a remark for a finding that the load is an estimate.
    [[nodiscard]] std::string remark(const Cable& cable) const;
};
BreakingLoad breaking_load(const Cable& cable);

}  // namespace fusee::checks
