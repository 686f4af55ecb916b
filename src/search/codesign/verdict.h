#pragma once
#include <vector>

#include "codesign/problem.h"

namespace fusee::search::codesign {

/// What bounds a feasible design: its limits within 1 % of being broken, without those that no searched number moves.
[[nodiscard]] std::vector<Limit> binding(const Trial& trial);

}  // namespace fusee::search::codesign
