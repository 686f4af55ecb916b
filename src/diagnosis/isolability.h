#pragma once
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/constants.h"
#include "fusee/inference/fit.h"

namespace fusee::diagnosis {

/// Signature similarity of `causes` in the experiments of a case, and the least size of each that they detect (docs/theory/isolability.md).
/// A cause's mark is what a usual size of it changes in the residuals of `null`, in sigmas with the weights of the fit, less what the build
/// parameters follow within their tolerances. In a class are causes that both stand out at their usual sizes, are similar by
/// inference::kSimilar, and of which one leaves less than inference::kSeen of the other's misfit; and what is connected by such pairs. A
/// size that no allowed one reaches is not detectable: kNoFigure. Of a limit (a stop, a saturation) the detectable size is the greatest.
[[nodiscard]] Isolability isolability(const inference::Problem& problem, const inference::Fit& null,
                                      const std::vector<inference::Cause>& causes, unsigned jobs);

}  // namespace fusee::diagnosis
