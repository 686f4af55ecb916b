#include "fusee/math/smoothing_spline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "penalised_fit.h"

namespace fusee::math {

namespace {

constexpr int kDegree = PenalisedFit::kDegree;
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

std::vector<double> differences(const std::vector<double>& values, double step) {
    std::vector<double> result(values.size() - 1);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = (values[i + 1] - values[i]) / step;
    return result;
}

}  // namespace

SmoothingSpline::SmoothingSpline(const std::vector<double>& x, const std::vector<double>& y, const SmoothingOptions& options)
    : domain_{x.front(), x.back()}, step_(domain_.width() / options.intervals) {
    assert(x.size() == y.size() && x.size() >= 3 && options.intervals >= 1 && domain_.width() > 0.0);
    std::vector<PenalisedFit::Row> rows;
    rows.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto [interval, share] = locate(x[i], domain_, step_, options.intervals);
        const auto values = basis(kDegree, share);
        PenalisedFit::Row& row = rows.emplace_back(PenalisedFit::Row{static_cast<std::size_t>(interval), {}, y[i]});
        std::copy_n(values.begin(), row.values.size(), row.values.begin());
    }
    const auto fit = make_penalised_fit(rows, static_cast<std::size_t>(options.intervals + kDegree));
    lambda_ = options.lambda < 0.0 ? fit->choose_lambda() : options.lambda;
    const PenalisedFit::Result result = fit->solve(lambda_);
    effective_parameters_ = result.parameters;
    const double left = static_cast<double>(rows.size()) - result.parameters;
    noise_ = left > 0.5 ? std::sqrt(result.residual / left) : 0.0;
    derivatives_[0] = result.coefficients;
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
    // B-splines are positive and sum to 1: counted from a middle coefficient, the sum hardly widens.
    const double central = at(degree / 2);
    const auto values = basis(degree, share), slopes = basis(degree - 1, share);
    Jet sum(central);
    for (int j = 0; j <= degree; ++j) sum.value += (Interval(at(j)) - central) * values[static_cast<std::size_t>(j)];
    for (int j = 0; j < degree; ++j) sum.slope += (Interval(at(j + 1)) - at(j)) / step_ * slopes[static_cast<std::size_t>(j)];
    return sum;
}

}  // namespace fusee::math
