#include "fusee/inference/interval.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/inference/constants.h"

namespace fusee::inference {

namespace {

/// x[k] of the refits without an experiment whose others would see such a size: the rest go back to the prior and say nothing.
std::vector<double> sizes_without(const Fit& fit, const Split& left_out, int k) {
    std::vector<double> sizes;
    for (std::size_t e = 0; e < left_out.x.size(); ++e)
        if (left_out.x[e].size() > 0 && kWitness * left_out.sigma[e][k] < std::abs(fit.x[k])) sizes.push_back(left_out.x[e][k]);
    return sizes;
}

}  // namespace

double student95(std::size_t samples) {
    constexpr std::array kStudent95{3.182446, 2.776445, 2.570582};  // of 3, 4 and 5 degrees of freedom
    return kStudent95[std::clamp<std::size_t>(samples, 4, 6) - 4];
}

double half_interval(const Fit& fit, const Split& left_out, int k) {
    const std::vector<double> sizes = sizes_without(fit, left_out, k);
    const double n = static_cast<double>(sizes.size());
    double mean = 0.0, square = 0.0;
    for (const double size : sizes) mean += size / n;
    for (const double size : sizes) square += (size - mean) * (size - mean);
    const double jackknife = n > 1.0 ? square * (n - 1.0) / n : 0.0;
    return std::hypot(kNormal95 * std::sqrt(fit.covariance(k, k)), kNormal95 * kLawAccuracy * fit.x[k],
                      student95(sizes.size()) * std::sqrt(jackknife));
}

Causes contradicted(const Problem& problem, const Fit& fit, const Split& left_out) {
    Causes causes;
    for (std::size_t c = 0; c < fit.causes.size(); ++c) {
        const int k = problem.effect_size_index(fit.causes, c);
        const bool stands_off = std::abs(fit.x[k]) >= kStandOff * half_interval(fit, left_out, k);
        if (!stands_off && !problem.effect(fit.causes[c].id).is_limit()) causes.push_back(fit.causes[c]);
    }
    return causes;
}

Causes at_bounds(const Problem& problem, const Fit& fit) {
    Causes causes;
    for (std::size_t c = 0; c < fit.causes.size(); ++c) {
        const int k = problem.effect_size_index(fit.causes, c);
        const core::Range allowed = problem.allowed(fit.causes, k);
        const bool inside = fit.x[k] > allowed.low + kAtEnd * allowed.width() && fit.x[k] < allowed.high - kAtEnd * allowed.width();
        if (!inside) causes.push_back(fit.causes[c]);
    }
    return causes;
}

}  // namespace fusee::inference
