#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <set>

#include "friction_line.h"
#include "fusee/math/statistics.h"

namespace fusee::gap_case {

namespace {

constexpr std::size_t kNamed = 5;  // rows that a remark names

std::string places(const std::vector<BreakAway>& rows, const std::vector<std::size_t>& which) {
    std::string out;
    for (std::size_t i = 0; i < std::min(kNamed, which.size()); ++i) {
        const std::size_t line = rows[which[i]].line;
        out += fmt::format("{}{}", i == 0 ? "" : ", ", line > 0 ? fmt::format("line {}", line) : fmt::format("row {}", which[i] + 1));
    }
    return which.size() > kNamed ? fmt::format("{} and {} more", out, which.size() - kNamed) : out;
}

/// Probability that equal lines differ as much as these (F test on constants and slopes together).
double chance_of_difference(const std::vector<FrictionLine>& lines) {
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    std::vector<Eigen::Matrix2d> precisions;
    std::size_t freedom = 0;
    const auto coefficients = [](const FrictionLine& line) { return Eigen::Vector2d(line.constant, line.mu); };
    for (const FrictionLine& line : lines) {
        const auto& c = line.fit.covariance;
        const Eigen::Matrix2d covariance{{c[0][0] + kRounding, c[0][1]}, {c[1][0], c[1][1] + kRounding}};
        precisions.push_back(covariance.inverse());
        information += precisions.back();
        sum += precisions.back() * coefficients(line);
        freedom += line.fit.freedom;
    }
    const Eigen::Vector2d common = information.inverse() * sum;
    double distance = 0.0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Eigen::Vector2d off = coefficients(lines[i]) - common;
        distance += off.dot(precisions[i] * off);
    }
    const std::size_t tested = 2 * (lines.size() - 1);
    return math::f_tail(distance / static_cast<double>(tested), tested, freedom);
}

std::string each(const std::vector<FrictionLine>& lines) {
    std::string out;
    for (std::size_t i = 0; i < std::min(kNamed, lines.size()); ++i)
        out += fmt::format("{}{}: {:.4g} Nm + {:.4g} load", i == 0 ? "" : "; ", lines[i].group, lines[i].constant, lines[i].mu);
    return out;
}

FrictionRemark on_constant(const FrictionLine& line) {
    const double variance = line.fit.covariance[0][0] + kRounding;
    const double p = math::f_tail(line.constant * line.constant / variance, 1, line.fit.freedom);
    const std::string constant = with_interval(line.constant, line.constant_95);
    if (line.constant_95.holds(0.0))
        return {"constant",
                fmt::format("the constant {} Nm is not distinguishable from 0: friction in proportion to the load, mu = {}", constant,
                            with_interval(line.through_zero_mu, line.through_zero_mu_95)),
                p};
    return {"constant",
            fmt::format("a constant friction of {} Nm acts in addition to mu = {}: a line through zero would {}state mu", constant,
                        with_interval(line.mu, line.mu_95), line.constant > 0.0 ? "over" : "under"),
            p};
}

void add_directions(const Fitted& fitted, std::vector<FrictionRemark>& remarks) {
    if (fitted.directions.size() != 2) return;
    const double p = chance_of_difference(fitted.directions);
    if (p >= kChance) return;
    remarks.push_back({"directions", fmt::format("the directions differ: {}", each(fitted.directions)), p});
}

void add_sides(const Fitted& fitted, std::vector<FrictionRemark>& remarks) {
    if (fitted.sides.size() < 2) return;
    const double p = chance_of_difference(fitted.sides);
    if (p >= kChance) return;
    const std::string more = fitted.sides.size() > kNamed ? fmt::format(" and {} more", fitted.sides.size() - kNamed) : "";
    remarks.push_back(
        {"sides", fmt::format("the sides differ: {}{}; the law below is a mean and fits neither motor", each(fitted.sides), more), p});
}

/// A term in load^2 in each of the finest groups, all tested together.
void add_curvature(const Fitted& fitted, std::vector<FrictionRemark>& remarks) {
    double distance = 0.0, sum = 0.0, precision = 0.0;
    std::size_t tested = 0, freedom = 0;
    for (const Group& group : fitted.finest) {
        math::LinearModel model = line_model(fitted.rows, group, fitted.weights);
        const std::set<double> loads(model.instruments[1].begin(), model.instruments[1].end());
        if (loads.size() < 3 || model.y.size() < 4) continue;
        for (auto* columns : {&model.x, &model.instruments}) {
            std::vector<double> squares = (*columns)[1];
            for (double& value : squares) value *= value;
            columns->push_back(std::move(squares));
        }
        const math::LinearFit fit = math::fit_linear(model);
        const double variance = fit.covariance[2][2] + kRounding;
        distance += fit.coefficients[2] * fit.coefficients[2] / variance;
        sum += fit.coefficients[2] / variance;
        precision += 1.0 / variance;
        freedom += fit.freedom;
        ++tested;
    }
    if (tested == 0) return;
    const double p = math::f_tail(distance / static_cast<double>(tested), tested, freedom);
    if (p >= kChance) return;
    remarks.push_back(
        {"curvature",
         fmt::format("friction is not linear in the load: the data show a term {:.3g} load^2; use a tabulated law", sum / precision), p});
}

void add_rows(const Fitted& fitted, std::vector<FrictionRemark>& remarks) {
    if (!fitted.outliers.empty())
        remarks.push_back(
            {"outliers",
             fmt::format("{} row{} far off the line, {} the law below: {}", fitted.outliers.size(),
                         fitted.outliers.size() == 1 ? " lies" : "s lie",
                         fitted.trusted.rows < fitted.rows.size() ? "left out of" : "but kept, since the other rows give none, in",
                         places(fitted.rows, fitted.outliers))});
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < fitted.rows.size(); ++i)
        if (fitted.rows[i].friction() < 0.0) wrong.push_back(i);
    if (!wrong.empty())
        remarks.push_back({"wrong_way", fmt::format("{} row{} the load on the wrong side of the motor torque for the direction given: {}",
                                                    wrong.size(), wrong.size() == 1 ? " has" : "s have", places(fitted.rows, wrong))});
    if (fitted.scatter.growth > 0.5)
        remarks.push_back({"scatter", "the scatter grows with the friction: rows are weighted by the inverse of their variance"});
}

}  // namespace

std::string with_interval(double value, const core::Range& range) {
    return fmt::format("{:.4g} ({:.4g} to {:.4g})", value, range.low, range.high);
}

std::vector<FrictionRemark> remarks_on(const Fitted& fitted) {
    std::vector<FrictionRemark> remarks{on_constant(fitted.trusted)};
    add_directions(fitted, remarks);
    add_sides(fitted, remarks);
    add_curvature(fitted, remarks);
    add_rows(fitted, remarks);
    return remarks;
}

}  // namespace fusee::gap_case
