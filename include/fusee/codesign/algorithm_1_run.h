#pragma once
#include "fusee/codesign/run.h"
#include "fusee/core/finding.h"
#include "fusee/report/search.h"

namespace fusee::codesign {

/// Algorithm 1 on the profile's rig, from the law's start torque to the motors' peak torque, for springs that exist up to the law's end
/// torque. Writes out/NAME-design: design.json, design.html, history.csv, figure_9.csv and NAME-best.toml, the profile with the law found.
/// Not found ("design.feasible", with what to change): no (k, u, C) in the box is a pair of springs, or none of those costs less than
/// springs that are none. Whether the law found can be cut into cams on the profile's base springs is judged and written down, not asked
/// for.
/// @throws InvalidInput naming the key; IoError
[[nodiscard]] RunResult run_algorithm_1(const profile::Profile& profile, const RunOptions& options);

/// The same search, its result in memory only; the checkpoint is written beside `options.out`, or not at all if that is empty.
/// Refusal: as above. @throws InvalidInput naming the key; IoError
[[nodiscard]] core::Outcome<report::SearchReport> search_algorithm_1(const profile::Profile& profile, const RunOptions& options);

}  // namespace fusee::codesign
