#pragma once
#include <string>
#include <vector>

#include "fusee/core/finding.h"

namespace fusee::report {

/// How the rules of one group ended: numbers of findings.
struct RuleCounts {
    std::string group;  ///< "spring" of "spring.stress"
    std::size_t passed = 0, not_judged = 0, review = 0, required = 0;
};
/// One row a group, in the order in which the groups first come.
[[nodiscard]] std::vector<RuleCounts> count_rules(const core::Findings& findings);
/// "31 rules not judged: spring 26, cable 4, shaft 1", the most first; empty if all were judged.
[[nodiscard]] std::string not_judged_text(const core::Findings& findings);

}  // namespace fusee::report
