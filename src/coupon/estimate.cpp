#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "fusee/coupon/calibration.h"
#include "fusee/math/statistics.h"

namespace fusee::coupon {

core::Range Estimate::interval(double confidence) const {
    constexpr double kMost = 1e6;  // Student's t is the normal distribution by then
    const auto whole = static_cast<std::size_t>(std::clamp(std::floor(freedom + 1e-9), 1.0, kMost));
    const double reach = math::student_quantile(confidence, whole) * deviation;
    return {value - reach, value + reach};
}

Estimate sum(const std::vector<Share>& shares) {
    Estimate total;
    double variance = 0.0, fourth = 0.0;
    for (const auto& [factor, of] : shares) {
        const double square = factor * factor * of.deviation * of.deviation;
        total.value += factor * of.value;
        variance += square;
        fourth += square * square / of.freedom;
    }
    total.deviation = std::sqrt(variance);
    total.freedom = fourth > 0.0 ? variance * variance / fourth : std::numeric_limits<double>::infinity();
    return total;
}

Line fit_line(const std::vector<Row>& rows, double resolution) {
    const auto count = static_cast<double>(rows.size());
    const double mean = std::accumulate(rows.begin(), rows.end(), 0.0, [](double s, const Row& r) { return s + r.given; }) / count;
    math::LinearModel model;
    model.x.assign(2, {});
    double spread = 0.0;  // sum of (x - mean)^2: level and slope are independent at the mean
    for (const Row& row : rows) {
        model.x[0].push_back(1.0);
        model.x[1].push_back(row.given - mean);
        model.y.push_back(row.measured);
        spread += (row.given - mean) * (row.given - mean);
    }
    const math::LinearFit fit = math::fit_linear(model);
    const double scatter = std::max(fit.deviation, resolution / std::sqrt(12.0)), freedom = count - 2.0;
    const Estimate level{fit.coefficients[0], scatter / std::sqrt(count), freedom};
    const Estimate slope{fit.coefficients[1], scatter / std::sqrt(spread), freedom};
    Line line{slope, sum({{1.0, level}, {-mean, slope}})};
    line.at_0.freedom = freedom;  // both have the same scatter
    return line;
}

}  // namespace fusee::coupon
