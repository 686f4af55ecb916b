#pragma once
#include <cmath>

#include "fusee/math/roots.h"

namespace fusee::cam {

/// The root of a monotone f between two samples; if rounding removes the change of sign, the end with the smaller value.
template <class F>
double solve_between(const F& f, double low, double high) {
    if (const auto root = math::bracketed_root(f, low, high)) return *root;
    return std::abs(f(low)) <= std::abs(f(high)) ? low : high;
}

}  // namespace fusee::cam
