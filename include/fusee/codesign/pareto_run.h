#pragma once
#include "fusee/codesign/run.h"

namespace fusee::codesign {

/// The front of designs that trade the exact dead-band against capstan travel or size ([co_design] against), by NSGA-II. Against travel
/// the travel demanded is where the front begins: a quarter of it. Every point is made with its solids, rules and files; what cannot be
/// made is dropped and counted. Writes out/NAME-design: pareto.csv, pareto.html and pareto/NN.toml, a profile for each point.
/// Ctrl-C ends with the front so far. Not found (what the nearest candidate breaks): nothing is written.
/// @throws InvalidInput naming the key; IoError
[[nodiscard]] RunResult run_pareto(const profile::Profile& profile, const RunOptions& options);

}  // namespace fusee::codesign
