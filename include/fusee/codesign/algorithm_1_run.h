#pragma once
#include "fusee/codesign/run.h"

namespace fusee::codesign {

/// Algorithm 1 on the profile's rig, from the law's start torque to the motors' peak torque, for springs that exist up to the law's end
/// torque. The profile found is NAME-best.toml: the profile with the law found. The checkpoint is written next to the result folder, or not
/// at all if `options.out` is empty.
/// Not found ("design.feasible", with a change): no (k, u, C) in the box is a pair of springs, or none of those costs less than the border
/// where the springs vanish. Whether the law found can be cut into cams on the profile's base springs is judged and reported, not required.
/// @throws InvalidInput naming the key; IoError
[[nodiscard]] RunResult run_algorithm_1(const profile::Profile& profile, const RunOptions& options);

}  // namespace fusee::codesign
