#pragma once
#include <functional>
#include <optional>

namespace fusee::math {

/// The x in [low, high] where a continuous f changes sign, to the last bit or two (Alefeld, Potra & Shi 1995, TOMS 748).
/// A huge f at one end is fine, an infinite one is not.
/// @return nothing if f(low) and f(high) have the same sign or are not numbers
[[nodiscard]] std::optional<double> bracketed_root(const std::function<double(double)>& f, double low, double high);

}  // namespace fusee::math
