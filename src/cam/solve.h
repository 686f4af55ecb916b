#pragma once
#include <cmath>

#include "fusee/math/roots.h"

namespace fusee::cam {

/// The root of a monotone f between two samples; where rounding leaves no change of sign, the end that is nearer to it.
template <class F>
double solve_between(const F& f, double low, double high) {
    if (const auto root = math::bracketed_root(f, low, high)) return *root;
    return std::abs(f(low)) <= std::abs(f(high)) ? low : high;
}

}  // namespace fusee::cam
