#include "friction_line.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numeric>

namespace fusee::gap_case {

namespace {

constexpr std::size_t kLeastRows = 3;             // two give a line without an interval
constexpr std::size_t kLeastRowsForOutliers = 8;  // of fewer rows the median deviation is not reliable
constexpr double kOutlier = 4.0;                  // robust deviations: one row in some thousands by chance, the median of few rows included
constexpr double kSpread = 1e-6;                  // of the loads, relative; below it is rounding in a million rows
constexpr double kMostGrowth = 0.9999;            // least deviation of a row, in typical ones: sensors always scatter

/// The straight line through (x, y) at each x: the mean of y if x has no spread.
void fit_within(const std::vector<double>& x, const std::vector<double>& y, const std::vector<std::size_t>& members,
                std::vector<double>& fitted) {
    double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
    for (const std::size_t i : members) {
        mean_x += x[i] / static_cast<double>(members.size());
        mean_y += y[i] / static_cast<double>(members.size());
    }
    for (const std::size_t i : members) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    const double slope = xx > 0.0 ? xy / xx : 0.0;
    for (const std::size_t i : members) fitted[i] = mean_y + slope * (x[i] - mean_x);
}

double squares(const std::vector<double>& v) { return std::inner_product(v.begin(), v.end(), v.begin(), 0.0); }

double r_squared(const math::LinearModel& model, const std::vector<double>& residuals) {
    const double rows = static_cast<double>(model.y.size());
    const double mean = std::accumulate(model.y.begin(), model.y.end(), 0.0) / rows;
    const double total = squares(model.y) - rows * mean * mean;
    return total > 0.0 ? 1.0 - squares(residuals) / total : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

math::LinearModel line_model(const std::vector<BreakAway>& rows, const Group& group, const std::vector<double>& weights) {
    const std::size_t count = group.rows.size();
    std::vector<double> motor(count), load(count), explained(count);
    math::LinearModel model;
    std::vector<std::size_t> directions[2];
    for (std::size_t i = 0; i < count; ++i) {
        const BreakAway& row = rows[group.rows[i]];
        motor[i] = row.motor_torque;
        load[i] = row.load_torque;
        directions[row.backdrive ? 1 : 0].push_back(i);
        model.y.push_back(row.friction());
        model.weights.push_back(weights[group.rows[i]]);
    }
    for (const std::vector<std::size_t>& members : directions) fit_within(motor, load, members, explained);
    const std::vector<double> ones(count, 1.0);
    model.x = {ones, std::move(load)};
    model.instruments = {ones, std::move(explained)};
    return model;
}

bool has_line(const math::LinearModel& model) {
    if (model.y.size() < kLeastRows) return false;
    const auto [low, high] = std::minmax_element(model.instruments[1].begin(), model.instruments[1].end());
    return *high - *low > kSpread * std::abs(*high);
}

std::vector<std::size_t> outliers_of(const Group& group, const math::RobustFit& robust) {
    std::vector<std::size_t> outliers;
    if (group.rows.size() < kLeastRowsForOutliers) return outliers;
    for (std::size_t i = 0; i < group.rows.size(); ++i)
        if (std::abs(robust.scores[i]) > kOutlier) outliers.push_back(group.rows[i]);
    return outliers;
}

FrictionLine fit_line(const Group& group, const math::LinearModel& model) {
    FrictionLine line;
    line.group = group.name;
    line.rows = group.rows.size();
    line.fit = math::fit_linear(model);
    line.constant = line.fit.coefficients[0];
    line.mu = line.fit.coefficients[1];
    line.constant_95 = line.fit.interval(0);
    line.mu_95 = line.fit.interval(1);
    line.scatter = std::sqrt(squares(line.fit.residuals) / static_cast<double>(line.fit.freedom));
    line.r_squared = r_squared(model, line.fit.residuals);

    const math::RobustFit robust = math::fit_robust(model);
    line.robust_constant = robust.coefficients[0];
    line.robust_mu = robust.coefficients[1];
    line.outliers = outliers_of(group, robust);

    const math::LinearFit through_zero = math::fit_linear({{model.x[1]}, model.y, {model.instruments[1]}, model.weights});
    line.through_zero_mu = through_zero.coefficients[0];
    line.through_zero_mu_95 = through_zero.interval(0);
    return line;
}

double Scatter::weight(double friction) const {
    const double relative = friction / typical;
    return 1.0 / (1.0 - growth + growth * relative * relative);
}

Scatter most_likely_scatter(const std::vector<double>& frictions, const std::vector<double>& residuals) {
    const double rows = static_cast<double>(frictions.size());
    Scatter scatter{0.0, std::sqrt(squares(frictions) / rows)};
    if (!(scatter.typical > 0.0) || !(squares(residuals) > 0.0)) return {};
    // Minus the logarithm of the likelihood, the common factor s^2 at its best.
    const auto unlikely = [&](double growth) {
        const Scatter tried{growth, scatter.typical};
        double sum = 0.0, logs = 0.0;
        for (std::size_t i = 0; i < frictions.size(); ++i) {
            const double weight = tried.weight(frictions[i]);
            sum += weight * residuals[i] * residuals[i];
            logs += std::log(weight);
        }
        return 0.5 * (rows * std::log(sum) - logs);
    };
    constexpr int kBits = 20;
    scatter.growth = boost::math::tools::brent_find_minima(unlikely, 0.0, kMostGrowth, kBits).first;
    return scatter;
}

}  // namespace fusee::gap_case
