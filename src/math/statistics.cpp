#include "fusee/math/statistics.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace fusee::math {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double upper_median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double quantile(const std::vector<double>& sorted, double share) {
    const double at = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    return std::lerp(sorted[below], sorted[std::min(below + 1, sorted.size() - 1)], at - std::floor(at));
}

double student_quantile(double confidence, std::size_t freedom) {
    return boost::math::quantile(boost::math::students_t(static_cast<double>(freedom)), 0.5 + 0.5 * confidence);
}

double f_tail(double f, std::size_t numerator_freedom, std::size_t denominator_freedom) {
    const boost::math::fisher_f distribution(static_cast<double>(numerator_freedom), static_cast<double>(denominator_freedom));
    return boost::math::cdf(boost::math::complement(distribution, f));
}

}  // namespace fusee::math
