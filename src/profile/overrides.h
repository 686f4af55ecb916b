#pragma once
#include <toml++/toml.h>

#include <string>
#include <vector>

#include "fusee/checks/check.h"
#include "fusee/core/toml.h"
#include "fusee/profile/keys.h"

/// The tables [[limits]]: limits of a profile instead of the rules' defaults.
namespace fusee::profile {

/// @param node the value of "limits" in the file
/// @param faults gets each mistake: not an array of tables; an unknown rule; a limit that the rule does not have, is in another unit, is
/// not finite or is repeated; no limit or no reason
[[nodiscard]] std::vector<checks::Override> read_overrides(const toml::node& node, const RuleInfos& rules, core::TomlFaults& faults);
/// The rules that a profile may name.
[[nodiscard]] RuleInfos design_rules();

/// The limits as TOML.
[[nodiscard]] std::string overrides_toml(const std::vector<checks::Override>& limits);

/// Their section of docs/profile.md.
[[nodiscard]] std::string overrides_reference();

}  // namespace fusee::profile
