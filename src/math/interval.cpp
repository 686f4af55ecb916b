#include "fusee/math/interval.h"

#include <algorithm>

namespace fusee::math {

namespace {

using Rounding = OutwardRounding;

}  // namespace

// Boost's intersect returns an empty interval if rounding leaves a last bit between the two.
Interval common(const Interval& a, const Interval& b) {
    const double low = std::max(a.lower(), b.lower()), high = std::min(a.upper(), b.upper());
    return low <= high ? Interval(low, high) : a;
}

Interval expm1(const Interval& x) { return {Rounding::well_below(std::expm1(x.lower())), Rounding::well_above(std::expm1(x.upper()))}; }

Interval log1p(const Interval& x) {
    if (!(x.lower() > -1.0)) return whole_line();
    return {Rounding::well_below(std::log1p(x.lower())), Rounding::well_above(std::log1p(x.upper()))};
}

// Nothing is known where a box leaves a function's domain; Boost would silently cut it off.
Jet sqrt(const Jet& x) {
    if (!(x.value.lower() > 0.0)) return Jet::anything();
    const Interval root = boost::numeric::sqrt(x.value);
    return {root, x.slope / (2.0 * root)};
}

Jet exp(const Jet& x) {
    const Interval value = boost::numeric::exp(x.value);
    return {value, value * x.slope};
}

Jet expm1(const Jet& x) { return {expm1(x.value), boost::numeric::exp(x.value) * x.slope}; }

Jet log1p(const Jet& x) { return {log1p(x.value), x.slope / (1.0 + x.value)}; }

Jet acos(const Jet& x) {
    if (!(x.value.lower() > -1.0 && x.value.upper() < 1.0)) return Jet::anything();
    return {boost::numeric::acos(x.value), -x.slope / boost::numeric::sqrt(1.0 - boost::numeric::square(x.value))};
}

Jet cube(const Jet& x) {
    const Interval square = boost::numeric::square(x.value);
    return {square * x.value, 3.0 * square * x.slope};
}

}  // namespace fusee::math
