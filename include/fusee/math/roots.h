#pragma once
#include <functional>
#include <optional>

namespace fusee::math {

/// The x in [low, high] where a continuous f changes sign, to the last bit or two (Alefeld, Potra & Shi 1995, TOMS 748).
/// f may be huge at an end, but not infinite.
/// @return nothing if f(low) and f(high) have the same sign or are not numbers
[[nodiscard]] std::optional<double> bracketed_root(const std::function<double(double)>& f, double low, double high);

/// Value and slope of a function at one place.
struct Tangent {
    double value = 0.0;
    double slope = 0.0;
};
/// The root in [low, high] of a rising function, to the last bit or two: Newton's steps from `start`; a step that would leave the bracket
/// halves it instead. An end of the bracket if the root lies beyond it.
[[nodiscard]] double rising_root(const std::function<Tangent(double)>& f, double low, double high, double start);

}  // namespace fusee::math
