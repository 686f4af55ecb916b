#pragma once
#include <toml++/toml.h>

#include <string>
#include <vector>

#include "faults.h"
#include "fusee/checks/check.h"
#include "fusee/profile/limits.h"

/// The tables [[limits]]: what a profile puts in the place of the rules' own limits.
namespace fusee::profile {

/// @param node what stands under "limits" in the file
/// @param faults gets each mistake: no array of tables; a rule that is not known; a limit that the rule does not have, one in another unit,
/// one that is no finite number or stands twice; no limit or no reason
[[nodiscard]] std::vector<checks::Override> read_overrides(const toml::node& node, const RuleInfos& rules, Faults& faults);
/// Those that a profile may name.
[[nodiscard]] RuleInfos design_rules();

/// The same as TOML.
[[nodiscard]] std::string overrides_toml(const std::vector<checks::Override>& limits);

/// Their part of docs/profile.md.
[[nodiscard]] std::string overrides_reference();

}  // namespace fusee::profile
