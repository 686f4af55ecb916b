#pragma once
#include <vector>

#include "fusee/codesign/problem.h"

namespace fusee::codesign {

/// What bounds a feasible design: its limits within 1 % of being broken, without those that no searched number moves.
[[nodiscard]] std::vector<Limit> binding(const Trial& trial);

}  // namespace fusee::codesign
