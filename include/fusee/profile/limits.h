#pragma once
#include <filesystem>
#include <vector>

#include "fusee/checks/rule.h"

namespace fusee::profile {

/// Rules that a [[limits]] may name: ids, limits and units; in the order in which they are listed.
using RuleInfos = std::vector<const checks::RuleInfo*>;

/// A file that holds nothing but [[limits]], of these rules: what a mesh by anybody is judged by, which has no profile of its own
/// (docs/guides/check.md). @throws core::IoError if it is missing, too large or no TOML @throws core::InvalidInput(s) "file:line:column:
/// KEY": any other key, and whatever is refused in a profile's [[limits]]
[[nodiscard]] std::vector<checks::Override> read_limits(const std::filesystem::path& path, const RuleInfos& rules);

}  // namespace fusee::profile
