#pragma once
#include "fusee/codesign/run.h"

namespace fusee::codesign {

/// Searches law, base springs, radius and lead-in together for the least exact dead-band that [co_design] allows; makes the best with its
/// solids and every rule, in a temporary folder. The profile found is NAME-best.toml.
/// Not found: the limits that the best candidate breaks, or the findings that refused its solids.
/// @throws InvalidInput naming the key; IoError
[[nodiscard]] RunResult run_co_design(const profile::Profile& profile, const RunOptions& options);

}  // namespace fusee::codesign
