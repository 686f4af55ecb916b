#pragma once
#include "fusee/codesign/run.h"

namespace fusee::codesign {

/// Law, base springs, radius and lead-in together, for the least exact dead-band that [co_design] allows; the best is then made with its
/// solids and every rule, in a temporary folder. Writes out/NAME-design: design.json, design.html, history.csv and NAME.toml, the profile
/// of the design found.
/// Not found (the limits that the best candidate breaks, or what refused its solids): nothing is written.
/// @throws InvalidInput naming the key; IoError
[[nodiscard]] RunResult run_co_design(const profile::Profile& profile, const RunOptions& options);

}  // namespace fusee::codesign
