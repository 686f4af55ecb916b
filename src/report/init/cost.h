#pragma once
#include <string>

#include "fusee/checks/limits.h"

namespace fusee::report {

inline constexpr const char* kNoPrices = "prices and machine time are not known: a slicer or a shop states them";

/// "38 cm3, 47 g if solid"
[[nodiscard]] std::string solid_amount(double mm3, const checks::Material& material);

}  // namespace fusee::report
