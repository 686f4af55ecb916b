#pragma once
#include "fusee/codesign/run.h"

namespace fusee::codesign {

/// The front of designs that trade the exact dead-band against capstan travel or size ([co_design] against), by NSGA-II. Against travel the
/// front begins at a quarter of the travel demanded. Every point is made with its solids, rules and files; a point that cannot be made is
/// dropped and counted. The profiles found are pareto/NN.toml. A stop ends the search with the front so far.
/// Not found: the limits that the nearest candidate breaks.
/// @throws InvalidInput naming the key; IoError
[[nodiscard]] RunResult run_pareto(const profile::Profile& profile, const RunOptions& options);

}  // namespace fusee::codesign
