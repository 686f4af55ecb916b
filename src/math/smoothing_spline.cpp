#include "fusee/math/smoothing_spline.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace fusee::math {

namespace {

constexpr int kDegree = 5;
constexpr int kMostDegree = kDegree + 1;  // of the integral

/// The degree + 1 uniform B-splines that differ from 0 at the share t of a knot interval (Cox-de Boor on integer knots).
template <class T>
std::array<T, kMostDegree + 1> basis(int degree, const T& t) {
    std::array<T, kMostDegree + 1> values{1.0};
    for (int j = 1; j <= degree; ++j) {
        T saved = 0.0;
        for (int r = 0; r < j; ++r) {
            const auto at = static_cast<std::size_t>(r);
            const T part = values[at] / static_cast<double>(j);
            values[at] = saved + (static_cast<double>(r + 1) - t) * part;
            saved = (t + static_cast<double>(j) - static_cast<double>(r) - 1.0) * part;
        }
        values[static_cast<std::size_t>(j)] = saved;
    }
    return values;
}

struct Position {
    int interval;
    double share;
};
Position locate(double x, core::Range domain, double step, int intervals) {
    const double s = (std::clamp(x, domain.low, domain.high) - domain.low) / step;
    const int interval = std::clamp(static_cast<int>(s), 0, intervals - 1);
    return {interval, s - interval};
}

/// Rows of B-splines over rows of their third differences; the fit solves [B; sqrt(lambda) D] c = [y; 0].
class PenalisedFit {
public:
    PenalisedFit(Eigen::MatrixXd design, Eigen::VectorXd y) : design_(std::move(design)), y_(std::move(y)) {
        const Eigen::Index count = design_.cols();
        penalty_ = Eigen::MatrixXd::Zero(count - 3, count);
        for (Eigen::Index i = 0; i + 3 < count; ++i) penalty_.row(i).segment<4>(i) << -1.0, 3.0, -3.0, 1.0;
        scale_ = design_.squaredNorm() / penalty_.squaredNorm();
    }

    struct Result {
        Eigen::VectorXd coefficients;
        double residual = 0.0;    ///< sum of squares
        double parameters = 0.0;  ///< trace of the smoother
        [[nodiscard]] double score(double rows) const {
            const double left = rows - 1.4 * parameters;
            return left > 0.0 ? rows * residual / (left * left) : std::numeric_limits<double>::infinity();
        }
    };

    [[nodiscard]] Result solve(double lambda) const {
        const Eigen::Index rows = design_.rows(), count = design_.cols(), all = rows + penalty_.rows();
        Eigen::MatrixXd stacked(all, count);
        stacked << design_, std::sqrt(lambda) * penalty_;
        Eigen::VectorXd right = Eigen::VectorXd::Zero(all);
        right.head(rows) = y_;
        // Rank-revealing: without a penalty, knots between which no row lies leave coefficients free; the least ones are taken.
        const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors(stacked);
        Result result;
        result.coefficients = factors.solve(right);
        result.residual = (design_ * result.coefficients - y_).squaredNorm();
        const Eigen::MatrixXd q = factors.householderQ() * Eigen::MatrixXd::Identity(all, factors.rank());
        result.parameters = q.topRows(rows).squaredNorm();
        return result;
    }

    /// Coarse scan (the score may have several valleys), then Brent's method in the best one.
    [[nodiscard]] double choose_lambda() const {
        constexpr double kLow = -9.0, kHigh = 9.0, kStep = 0.5;  // decades around the weight that balances design and penalty
        const auto score = [this](double decade) {
            return solve(scale_ * std::pow(10.0, decade)).score(static_cast<double>(design_.rows()));
        };
        double best = kHigh, least = score(kHigh);  // ties and hopeless rows: the smoothest
        for (double decade = kHigh - kStep; decade >= kLow; decade -= kStep)
            if (const double now = score(decade); now < least) least = now, best = decade;
        constexpr int kBits = 12;  // a thousandth of a decade is far more than the score can tell
        const auto refined = boost::math::tools::brent_find_minima(score, best - kStep, best + kStep, kBits);
        return scale_ * std::pow(10.0, refined.second < least ? refined.first : best);
    }

private:
    Eigen::MatrixXd design_, penalty_;
    Eigen::VectorXd y_;
    double scale_ = 1.0;
};

std::vector<double> differences(const std::vector<double>& values, double step) {
    std::vector<double> result(values.size() - 1);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = (values[i + 1] - values[i]) / step;
    return result;
}

}  // namespace

SmoothingSpline::SmoothingSpline(const std::vector<double>& x, const std::vector<double>& y, const SmoothingOptions& options)
    : domain_{x.front(), x.back()}, step_(domain_.width() / options.intervals) {
    assert(x.size() == y.size() && x.size() >= 3 && options.intervals >= 1 && domain_.width() > 0.0);
    const auto rows = static_cast<Eigen::Index>(x.size());
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(rows, options.intervals + kDegree);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const auto [interval, share] = locate(x[static_cast<std::size_t>(row)], domain_, step_, options.intervals);
        const auto values = basis(kDegree, share);
        for (int j = 0; j <= kDegree; ++j) design(row, interval + j) = values[static_cast<std::size_t>(j)];
    }
    const PenalisedFit fit(std::move(design), Eigen::Map<const Eigen::VectorXd>(y.data(), rows));
    lambda_ = options.lambda < 0.0 ? fit.choose_lambda() : options.lambda;
    const PenalisedFit::Result result = fit.solve(lambda_);
    effective_parameters_ = result.parameters;
    const double left = static_cast<double>(rows) - result.parameters;
    noise_ = left > 0.5 ? std::sqrt(result.residual / left) : 0.0;
    derivatives_[0].assign(result.coefficients.begin(), result.coefficients.end());
    for (std::size_t i = 1; i < derivatives_.size(); ++i) derivatives_[i] = differences(derivatives_[i - 1], step_);
    integral_.resize(derivatives_[0].size() + 1, 0.0);
    std::partial_sum(derivatives_[0].begin(), derivatives_[0].end(), integral_.begin() + 1);
    for (double& coefficient : integral_) coefficient *= step_;
    const double at_low = evaluate(integral_, kDegree + 1, domain_.low);
    for (double& coefficient : integral_) coefficient -= at_low;  // B-splines sum to 1
}

double SmoothingSpline::evaluate(const std::vector<double>& coefficients, int degree, double x) const {
    const auto [interval, share] = locate(x, domain_, step_, static_cast<int>(coefficients.size()) - degree);
    const auto values = basis(degree, share);
    double sum = 0.0;
    for (int j = 0; j <= degree; ++j) sum += coefficients[static_cast<std::size_t>(interval + j)] * values[static_cast<std::size_t>(j)];
    return sum;
}

double SmoothingSpline::derivative(double x, int order) const {
    assert(order >= 0 && order <= 3);
    return evaluate(derivatives_[static_cast<std::size_t>(order)], kDegree - order, x);
}

double SmoothingSpline::integral(double x) const { return evaluate(integral_, kDegree + 1, x); }

std::vector<double> SmoothingSpline::breaks() const {
    std::vector<double> all;
    for (std::size_t i = 0; i + kDegree < derivatives_[0].size(); ++i) all.push_back(domain_.low + static_cast<double>(i) * step_);
    all.push_back(domain_.high);
    return all;
}

Jet SmoothingSpline::over(const Interval& x, int order) const {
    const int degree = kDegree - order;
    const std::vector<double>& c = coefficients(order);
    const int interval = locate(middle(x), domain_, step_, static_cast<int>(c.size()) - degree).interval;
    const Interval share = (x - domain_.low) / step_ - static_cast<double>(interval);
    const auto at = [&](int j) { return c[static_cast<std::size_t>(interval + j)]; };
    // B-splines are positive and sum to 1: counted from a value amid the coefficients, the sum hardly widens.
    const double amid = at(degree / 2);
    const auto values = basis(degree, share), slopes = basis(degree - 1, share);
    Jet sum(amid);
    for (int j = 0; j <= degree; ++j) sum.value += (Interval(at(j)) - amid) * values[static_cast<std::size_t>(j)];
    for (int j = 0; j < degree; ++j) sum.slope += (Interval(at(j + 1)) - at(j)) / step_ * slopes[static_cast<std::size_t>(j)];
    return sum;
}

}  // namespace fusee::math
