#pragma once
#include <vector>

#include "fusee/inference/model.h"
#include "fusee/simulator/case.h"

namespace fusee::simulator {

/// Of so many rows one is compared, from the first of each run on: 1 up to kMostCompared rows of an experiment. The simulator has them all.
inline constexpr std::size_t kMostCompared = 100'000;
[[nodiscard]] std::size_t stride_of(const Experiment& experiment);
/// The experiments of a case for the engine: run after run, the rows that are compared, output by output.
[[nodiscard]] std::vector<inference::Experiment> engine_experiments(const Case& of_case);
/// The parameters with a tolerance.
[[nodiscard]] std::vector<inference::BuildParameter> engine_build(const Case& of_case);
/// An effect of the case. @param experiments their number
[[nodiscard]] inference::Effect engine_effect(const Effect& effect, const Case& of_case);
/// The cause that a parameter with a tolerance is not what was stated.
[[nodiscard]] inference::Effect figure_effect(const Parameter& parameter, const Case& of_case);

}  // namespace fusee::simulator
