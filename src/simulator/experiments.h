#pragma once
#include <vector>

#include "fusee/inference/model.h"
#include "fusee/simulator/case.h"

namespace fusee::simulator {

/// The experiments of a case for the engine: run after run, row by row, output by output.
[[nodiscard]] std::vector<inference::Experiment> engine_experiments(const Case& of_case);
/// The parameters with a tolerance.
[[nodiscard]] std::vector<inference::BuildParameter> engine_build(const Case& of_case);
/// An effect of the case. @param experiments their number
[[nodiscard]] inference::Effect engine_effect(const Effect& effect, const Case& of_case);
/// The cause that a parameter with a tolerance is not what was stated.
[[nodiscard]] inference::Effect figure_effect(const Parameter& parameter, const Case& of_case);

}  // namespace fusee::simulator
