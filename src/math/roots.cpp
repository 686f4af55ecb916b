#include "fusee/math/roots.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

namespace fusee::math {

std::optional<double> bracketed_root(const std::function<double(double)>& f, double low, double high) {
    const double f_low = f(low), f_high = f(high);
    if (f_low == 0.0) return low;
    if (f_high == 0.0) return high;
    if (!(low < high) || std::isnan(f_low) || std::isnan(f_high) || (f_low < 0.0) == (f_high < 0.0)) return std::nullopt;
    // 200 halvings resolve the widest bracket of doubles; TOMS 748 needs about ten evaluations.
    std::uintmax_t evaluations = 200;
    const boost::math::tools::eps_tolerance<double> tight(std::numeric_limits<double>::digits - 1);
    const auto [left, right] = boost::math::tools::toms748_solve(f, low, high, f_low, f_high, tight, evaluations);
    return std::abs(f(left)) <= std::abs(f(right)) ? left : right;
}

double rising_root(const std::function<Tangent(double)>& f, double low, double high, double start) {
    constexpr int kMostSteps = 200;  // enough halvings for the widest bracket of doubles
    double x = std::clamp(start, low, high);
    for (int step = 0; step < kMostSteps; ++step) {
        const Tangent at = f(x);
        if (at.value == 0.0) break;
        (at.value > 0.0 ? high : low) = x;
        double next = x - at.value / at.slope;
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
        const double moved = std::abs(next - x);
        x = next;
        if (moved <= std::numeric_limits<double>::epsilon() * std::abs(x)) break;
    }
    return x;
}

}  // namespace fusee::math
