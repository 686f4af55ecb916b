#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/math/statistics.h"

namespace fusee::math {

namespace {

constexpr std::size_t kFewestDifferences = 16;  ///< of rows: fewer say nothing about their noise
constexpr int kLeastOrder = 3, kMostOrder = 6;  ///< of differences: each takes more of a course than of noise
constexpr double kOtherNoise = 1.5;             ///< times what was stated: from there on the rows have another noise
constexpr double kNormalQuartile = 0.6744898;   ///< median of |x| of a standard normal variable

/// (-1)^k binomial(order, k)
std::vector<double> coefficients(int order) {
    std::vector<double> all{1.0};
    for (int k = 1; k <= order; ++k) all.push_back(-all.back() * (order - k + 1) / k);
    return all;
}

}  // namespace

double scatter(const std::vector<Series>& series, int order) {
    const std::vector<double> by = coefficients(order);
    std::vector<double> sizes;
    for (const Series& own : series)
        for (std::size_t i = by.size() - 1; i < own.values.size(); ++i) {
            double difference = 0.0, variance = 0.0;
            for (std::size_t k = 0; k < by.size(); ++k) {
                difference += by[k] * own.values[i - k];
                variance += std::pow(by[k] * (own.sigma.empty() ? 1.0 : own.sigma[i - k]), 2);
            }
            sizes.push_back(std::abs(difference) / std::sqrt(variance));
        }
    if (sizes.size() < kFewestDifferences) return std::numeric_limits<double>::quiet_NaN();
    return upper_median(std::move(sizes)) / kNormalQuartile;
}

double scatter_of_repeats(const std::vector<Series>& groups) {
    std::vector<double> variances;
    std::size_t freedom = 0;
    for (const Series& group : groups) {
        if (group.values.size() < 2) continue;
        const double spare = static_cast<double>(group.values.size() - 1);
        double mean = 0.0, sum = 0.0;
        for (const double value : group.values) mean += value / (spare + 1.0);
        for (std::size_t i = 0; i < group.values.size(); ++i) sum += std::pow((group.values[i] - mean) / group.sigma[i], 2);
        variances.push_back(sum / spare / std::pow(1.0 - 2.0 / (9.0 * spare), 3));  // over the median of chi^2 (Wilson and Hilferty)
        freedom += group.values.size() - 1;
    }
    return freedom < kFewestDifferences ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(upper_median(std::move(variances)));
}

double least_scatter(const std::vector<Series>& series) {
    double least = scatter(series, kMostOrder);
    for (int order = kLeastOrder; order < kMostOrder; ++order) least = std::min(least, scatter(series, order));
    return least;  // NaN without enough of the highest order: the lower ones alone cannot tell a coarse course from noise
}

double noise_factor(double scatter) { return scatter > kOtherNoise ? scatter : 1.0; }

}  // namespace fusee::math
