#pragma once
#include <filesystem>
#include <vector>

#include "fusee/checks/rule.h"

namespace fusee::profile {

/// Rules that [[limits]] may name: ids, limits and units, in display order.
using RuleInfos = std::vector<const checks::RuleInfo*>;

/// Reads a file of [[limits]] only, of these rules: limits for a third-party mesh, which has no profile (docs/guides/check.md).
/// @throws core::IoError if it is missing, too large or not TOML
/// @throws core::InvalidInput(s) "file:line:column: KEY": any other key, and every fault of a profile's [[limits]]
[[nodiscard]] std::vector<checks::Override> read_limits(const std::filesystem::path& path, const RuleInfos& rules);

}  // namespace fusee::profile
