#pragma once
#include <optional>
#include <string>

#include "fusee/checks/check.h"

namespace fusee::checks {

/// What a measured value is held against. Breaking `required` forbids the part; breaking only `recommended` asks for a review.
struct Limits {
    std::optional<double> required = {}, recommended = {};
};

/// A judged finding without words. A value that misses its limit only by rounding (1e-9 relative) is on it.
core::Finding at_least(double measured, const Limits& limits, const std::string& unit);
core::Finding at_most(double measured, const Limits& limits, const std::string& unit);

/// "k_pe"
std::string name(const Design& design);
/// "k_pe at psi 12.0 deg"
std::string where(const Design& design, double psi);
/// @param offset from the cable's centreline along n [m]; -d/2 is the groove's floor
core::Place place(const cam::PathPoint& point, double offset);

/// Three significant digits, rounded so that the number is not below (up) or not above (down) `value`.
std::string up(double value);
std::string down(double value);

}  // namespace fusee::checks
