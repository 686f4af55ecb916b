#pragma once
#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/pursue.h"

namespace fusee::diagnosis {

/// A fitted parameter with its half interval, both in scales, in the unit of its law and within what is allowed.
[[nodiscard]] Parameter parameter_of(double value, double half, const inference::EffectParameter& law);

/// Each term with its values, its sentence and its curve over what it depends on.
[[nodiscard]] std::vector<UnknownTerm> unknown_terms(const inference::Problem& problem, const inference::FoundTerms& found);

}  // namespace fusee::diagnosis
