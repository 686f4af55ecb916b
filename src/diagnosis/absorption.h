#pragma once
#include "answer.h"

namespace fusee::diagnosis {

/// The fit of all build parameters without an effect, beside the fit that is shown: none if that has no cause, or if the model has no build
/// parameter. @pre stages.held_out is of the fit that is shown
[[nodiscard]] std::optional<Absorption> absorption_of(const inference::Problem& problem, const Stages& stages, unsigned jobs);

}  // namespace fusee::diagnosis
