#include "fusee/math/statistics.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

#include "fusee/core/error.h"

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

constexpr double kHuber = 1.345;                            // deviations: 95 % efficiency for normal noise
constexpr double kDeviationsOfMedian = 1.4826;              // 1/0.6745, the upper quartile of the normal distribution
constexpr int kReweightings = 200, kDeviationSettled = 15;  // then the deviation is fixed: the rest is a convex problem
constexpr double kSettled = 1e-12;                          // change of the coefficients, relative
constexpr double kDependent = 1e-10;                        // least pivot of columns of length 1: rounding is below

Eigen::MatrixXd matrix(const std::vector<std::vector<double>>& columns, const Eigen::VectorXd& factors) {
    Eigen::MatrixXd m(factors.size(), static_cast<Eigen::Index>(columns.size()));
    for (std::size_t j = 0; j < columns.size(); ++j) {
        assert(columns[j].size() == static_cast<std::size_t>(factors.size()));
        m.col(static_cast<Eigen::Index>(j)) = Eigen::Map<const Eigen::VectorXd>(columns[j].data(), factors.size()).cwiseProduct(factors);
    }
    return m;
}

/// The model with its rows multiplied by the square roots of their weights, so that all have the same variance.
struct Whitened {
    Eigen::VectorXd roots;  // of the weights
    Eigen::MatrixXd x, z;
    Eigen::VectorXd y;
};

Whitened whiten(const LinearModel& model) {
    const auto rows = static_cast<Eigen::Index>(model.y.size());
    if (model.y.size() <= model.x.size())
        throw core::InvalidInput("rows", std::to_string(model.y.size()), "more than " + std::to_string(model.x.size()));
    assert(model.instruments.empty() || model.instruments.size() == model.x.size());
    Whitened w;
    w.roots = Eigen::VectorXd::Ones(rows);
    if (!model.weights.empty()) w.roots = Eigen::Map<const Eigen::VectorXd>(model.weights.data(), rows).cwiseSqrt();
    w.x = matrix(model.x, w.roots);
    w.z = model.instruments.empty() ? w.x : matrix(model.instruments, w.roots);
    w.y = Eigen::Map<const Eigen::VectorXd>(model.y.data(), rows).cwiseProduct(w.roots);
    return w;
}

/// (Q'X) b = Q'y with Z = QR: the normal equations Z'(y - X b) = 0 without squaring their condition.
struct Solution {
    Eigen::VectorXd b;
    Eigen::MatrixXd inverse;  // of Q'X
};

Solution solve(const Whitened& w) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(w.z);
    const Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(w.z.rows(), w.z.cols());
    // Columns of length 1, so that units do not look like dependence.
    const Eigen::VectorXd scale = (w.x.colwise().norm().array() + std::numeric_limits<double>::min()).inverse();
    Eigen::FullPivLU<Eigen::MatrixXd> lu(q.transpose() * w.x * scale.asDiagonal());
    lu.setThreshold(kDependent);
    if (!lu.isInvertible()) throw core::InvalidInput("regression", "columns that depend on each other", "rows that differ in every column");
    return {scale.asDiagonal() * lu.solve(q.transpose() * w.y), scale.asDiagonal() * lu.inverse()};
}

std::vector<double> values(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

}  // namespace

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

core::Range LinearFit::interval(std::size_t j, double confidence) const {
    std::vector<double> at(coefficients.size(), 0.0);
    at.at(j) = 1.0;
    return interval_at(at, confidence);
}

core::Range LinearFit::interval_at(const std::vector<double>& at, double confidence) const {
    assert(at.size() == coefficients.size());
    double value = 0.0, variance = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        value += at[i] * coefficients[i];
        for (std::size_t j = 0; j < at.size(); ++j) variance += at[i] * covariance[i][j] * at[j];
    }
    const double reach = student_quantile(confidence, freedom) * std::sqrt(std::max(0.0, variance));
    return {value - reach, value + reach};
}

LinearFit fit_linear(const LinearModel& model) {
    const Whitened w = whiten(model);
    const Solution s = solve(w);
    const Eigen::VectorXd residuals = w.y - w.x * s.b;
    LinearFit fit;
    fit.coefficients = values(s.b);
    fit.residuals = values(residuals.cwiseQuotient(w.roots));
    fit.freedom = model.y.size() - model.x.size();
    fit.deviation = std::sqrt(residuals.squaredNorm() / static_cast<double>(fit.freedom));
    const Eigen::MatrixXd cofactors = s.inverse * s.inverse.transpose();
    const Eigen::MatrixXd covariance = fit.deviation * fit.deviation * s.inverse * s.inverse.transpose();
    for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
        fit.covariance.push_back(values(covariance.row(i)));
        fit.cofactors.push_back(values(cofactors.row(i)));
    }
    return fit;
}

RobustFit fit_robust(const LinearModel& model) {
    const Whitened plain = whiten(model);
    Whitened w = plain;
    Eigen::VectorXd b = solve(plain).b, residuals;
    const double least =
        1e-12 * plain.y.cwiseAbs().maxCoeff() + std::numeric_limits<double>::min();  // more than half of the rows may fit exactly
    RobustFit fit;
    for (int i = 0; i < kReweightings; ++i) {
        residuals = plain.y - plain.x * b;
        if (i < kDeviationSettled) fit.deviation = std::max(least, kDeviationsOfMedian * median(values(residuals.cwiseAbs())));
        const Eigen::VectorXd roots = (kHuber * fit.deviation / residuals.cwiseAbs().cwiseMax(least).array()).min(1.0).sqrt();
        w.x = roots.asDiagonal() * plain.x;
        w.z = roots.asDiagonal() * plain.z;
        w.y = roots.asDiagonal() * plain.y;
        const Eigen::VectorXd next = solve(w).b;
        const double change = (next - b).norm();
        b = next;
        if (change <= kSettled * b.norm()) break;
    }
    fit.coefficients = values(b);
    fit.scores = values((plain.y - plain.x * b) / fit.deviation);
    return fit;
}

}  // namespace fusee::math
