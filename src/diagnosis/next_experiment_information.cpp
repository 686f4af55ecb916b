#include "next_experiment_information.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fusee::diagnosis {

namespace {

/// E[log2(1 + exp(-(odds + d^2/2 + d z)))], z standard normal: the surprise left when the first of two hypotheses with log odds `odds` and
/// distance d is true. Trapezoidal rule, which converges faster than any power for such an integrand.
double surprise_left(double odds, double d) {
    constexpr double kQuadratureEnd = 9.0, kStep = 0.01;  // of z; the step is fine compared with 1/d if anything is left to integrate
    double sum = 0.0;
    for (double z = -kQuadratureEnd; z <= kQuadratureEnd; z += kStep) {
        const double log_odds = odds + 0.5 * d * d + d * z;
        const double softplus = std::max(0.0, -log_odds) + std::log1p(std::exp(-std::abs(log_odds)));
        sum += std::exp(-0.5 * z * z) * softplus;
    }
    return sum * kStep / std::sqrt(2.0 * std::numbers::pi) / std::numbers::ln2;
}

double of_two(double p, double d) {
    if (p <= 0.0 || p >= 1.0) return 0.0;
    const double odds = std::log(p / (1.0 - p));
    return -p * surprise_left(odds, d) - (1.0 - p) * surprise_left(-odds, d);
}

double bound_of_more(std::span<const double> p, const Eigen::MatrixXd& distances) {
    double bits = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p[i] <= 0.0) continue;
        double overlap = 0.0;
        for (std::size_t j = 0; j < p.size(); ++j) overlap += p[j] * std::exp(-distances(static_cast<int>(i), static_cast<int>(j)) / 8.0);
        bits -= p[i] * std::log2(overlap);
    }
    return bits;
}

}  // namespace

double entropy(std::span<const double> probabilities) {
    double bits = 0.0;
    for (const double p : probabilities)
        if (p > 0.0) bits -= p * std::log2(p);
    return bits;
}

double expected_information(std::span<const double> probabilities, const Eigen::MatrixXd& distances) {
    const double most = entropy(probabilities);
    const double bits =
        probabilities.size() == 2 ? most + of_two(probabilities[0], std::sqrt(distances(0, 1))) : bound_of_more(probabilities, distances);
    return std::clamp(bits, 0.0, most);
}

}  // namespace fusee::diagnosis
