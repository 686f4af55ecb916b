#pragma once
#include <span>
#include <vector>

#include "fusee/assembly/assembly.h"
#include "fusee/checks/judge.h"
#include "fusee/checks/rule.h"

/// Rules about the joint as a whole.
namespace fusee::assembly {

/// One rule: a row of its topic's table in src/assembly/rules.
struct Rule : checks::RuleInfo {
    using Measure = std::function<core::Findings(const Assembly&, const checks::Allowed&)>;
    Measure measure;
};
using Rules = std::vector<Rule>;

/// All rules, in the order of the report.
[[nodiscard]] std::span<const Rule> rules();

/// Runs every rule; what the model leaves out is not judged. @param overrides limits that replace the rules' own
[[nodiscard]] core::Findings check(const Assembly& assembly, std::span<const checks::Override> overrides);

}  // namespace fusee::assembly
