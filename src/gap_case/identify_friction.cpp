#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "friction_line.h"
#include "fusee/core/error.h"
#include "fusee/core/text.h"
#include "fusee/math/statistics.h"

namespace fusee::gap_case {

namespace {

// Friction and an error of the motor's torque constant: distinguished where a motor has both directions, and nowhere else.

constexpr double kConfidence = 0.95;

/// Rows of each side that count.
std::map<std::string, std::vector<std::size_t>> by_side(const std::vector<BreakAway>& rows, const std::vector<std::size_t>& left_out) {
    std::map<std::string, std::vector<std::size_t>> sides;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!std::binary_search(left_out.begin(), left_out.end(), i)) sides[rows[i].side].push_back(i);
    return sides;
}

std::set<double> distinct_torques(const std::vector<BreakAway>& rows, const std::vector<std::size_t>& which, bool backdrive) {
    std::set<double> torques;
    for (const std::size_t i : which)
        if (rows[i].backdrive == backdrive) torques.insert(rows[i].motor_torque);
    return torques;
}

bool has_both(const std::vector<BreakAway>& rows, const std::vector<std::size_t>& which) {
    return !distinct_torques(rows, which, true).empty() && !distinct_torques(rows, which, false).empty();
}

/// tau_m = a load + b s load + c s + d, s = -1 backdrive, +1 drive: a = 1/scale, b = mu/scale, c = constant/scale, d an offset of the
/// torque. Without two motor torques in each direction: a and b alone.
math::LinearModel torque_model(const std::vector<BreakAway>& rows, const Group& side, const std::vector<double>& weights) {
    const math::LinearModel line = line_model(rows, side, weights);
    const std::size_t count = side.rows.size();
    std::vector<double> sign(count), torque(count), signed_load(count), signed_explained(count);
    for (std::size_t i = 0; i < count; ++i) {
        const BreakAway& row = rows[side.rows[i]];
        sign[i] = row.backdrive ? -1.0 : 1.0;
        torque[i] = row.motor_torque;
        signed_load[i] = sign[i] * line.x[1][i];
        signed_explained[i] = sign[i] * line.instruments[1][i];
    }
    math::LinearModel model{
        {line.x[1], std::move(signed_load)}, std::move(torque), {line.instruments[1], std::move(signed_explained)}, line.weights};
    const bool lines = distinct_torques(rows, side.rows, true).size() > 1 && distinct_torques(rows, side.rows, false).size() > 1;
    if (lines && count > 5)
        for (auto* columns : {&model.x, &model.instruments}) {
            columns->push_back(sign);
            columns->push_back(line.x[0]);
        }
    return model;
}

/// coefficient `j` over the first, which is 1/scale.
std::pair<double, core::Range> over_first(const math::LinearFit& fit, std::size_t j) {
    const double a = fit.coefficients[0], ratio = fit.coefficients[j] / a;
    const auto& c = fit.covariance;
    const double variance = (c[j][j] - 2.0 * ratio * c[0][j] + ratio * ratio * c[0][0]) / (a * a);
    const double half = math::student_quantile(kConfidence, fit.freedom) * std::sqrt(std::max(variance, 0.0));
    return {ratio, {ratio - half, ratio + half}};
}

std::string less_or_more(double scale) {
    return fmt::format("{:.1f} % {} torque than stated", 100.0 * std::abs(scale - 1.0), scale < 1.0 ? "less" : "more");
}

/// The motors with both directions, by name; not those with too few rows for an interval.
/// @param left_out rows that do not count, ascending @param weights of all rows
std::vector<FrictionReport::Motor> motors_of(const std::vector<BreakAway>& rows, const std::vector<std::size_t>& left_out,
                                             const std::vector<double>& weights) {
    std::vector<FrictionReport::Motor> motors;
    for (auto& [side, which] : by_side(rows, left_out)) {
        if (!has_both(rows, which) || which.size() < 3) continue;
        const math::LinearFit fit = math::fit_linear(torque_model(rows, {side, which}, weights));
        const core::Range first = fit.interval(0);
        if (!(fit.coefficients[0] > 0.0) || !(first.low > 0.0)) continue;  // rows of no motor
        FrictionReport::Motor& motor = motors.emplace_back();
        motor.side = side;
        motor.rows = which.size();
        motor.scale = 1.0 / fit.coefficients[0];
        motor.scale_95 = {1.0 / first.high, 1.0 / first.low};
        std::tie(motor.mu, motor.mu_95) = over_first(fit, 1);
        if (fit.coefficients.size() > 2) std::tie(motor.constant, motor.constant_95) = over_first(fit, 2);
        const double off = fit.coefficients[0] - 1.0;
        motor.p = math::f_tail(off * off / (fit.covariance[0][0] + kRounding), 1, fit.freedom);
    }
    for (FrictionReport::Motor& motor : motors) motor.differs = motor.p * static_cast<double>(motors.size()) < kChance;
    return motors;
}

/// The motors with one direction only, by name.
std::vector<FrictionReport::OneWay> one_way_motors(const std::vector<BreakAway>& rows, const std::vector<std::size_t>& left_out,
                                                   const std::vector<double>& weights) {
    std::vector<FrictionReport::OneWay> all;
    for (auto& [side, which] : by_side(rows, left_out)) {
        const Group group{side, which};
        const math::LinearModel model = line_model(rows, group, weights);
        if (has_both(rows, which) || !has_line(model)) continue;
        const FrictionLine line = fit_line(group, model);
        const bool constant = line.constant_95.low > 0.0;
        FrictionReport::OneWay& motor = all.emplace_back();
        motor.side = side;
        motor.backdrive = rows[which.front()].backdrive;
        motor.rows = which.size();
        motor.mu = constant ? line.mu : line.through_zero_mu;
        motor.mu_95 = constant ? line.mu_95 : line.through_zero_mu_95;
        // Without friction load = scale tau_m, with it (1 +- mu) load = tau_m: one slope, read twice.
        const double s = motor.backdrive ? -1.0 : 1.0;
        motor.scale = 1.0 / (1.0 + s * motor.mu);
        const double one = 1.0 / (1.0 + s * motor.mu_95.low), other = 1.0 / (1.0 + s * motor.mu_95.high);
        motor.scale_95 = {std::min(one, other), std::max(one, other)};
        for (const std::size_t i : which) motor.motor_torque = std::max(motor.motor_torque, rows[i].motor_torque);
        motor.load_by_friction = (motor.motor_torque - s * (constant ? line.constant : 0.0)) / (1.0 - s * motor.mu);
        motor.load_by_scale = motor.scale * motor.motor_torque;
    }
    return all;
}

/// The rows with the torque that the motors give: times `scale` of those that differ.
std::vector<BreakAway> with_true_torques(std::vector<BreakAway> rows, const std::vector<FrictionReport::Motor>& motors) {
    for (BreakAway& row : rows)
        for (const FrictionReport::Motor& motor : motors)
            if (motor.differs && motor.side == row.side) row.motor_torque *= motor.scale;
    return rows;
}

FrictionRemark remark_on(const std::vector<FrictionReport::Motor>& motors) {
    std::string said;
    double p = 1.0;
    const bool differs = std::any_of(motors.begin(), motors.end(), [](const auto& motor) { return motor.differs; });
    for (const FrictionReport::Motor& motor : motors) {
        p = std::min(p, motor.p);
        if (differs && !motor.differs) continue;
        said += fmt::format("{}{} gives {} of the stated torque", said.empty() ? "" : "; ", motor.side,
                            with_interval(motor.scale, motor.scale_95));
        if (motor.differs)
            said += fmt::format(", {}, with mu = {} in both directions", less_or_more(motor.scale), with_interval(motor.mu, motor.mu_95));
    }
    return {"motor_torque",
            differs ? "the motor's torque is not the stated one: " + said +
                          ". The law below counts that torque: mend the torque constant. A gear whose friction differs between the "
                          "directions would give "
                          "the same rows; a torque meter between motor and gear tells"
                    : "friction and torque constant are distinguished by the two directions: " + said,
            p};
}

FrictionRemark remark_on(const FrictionReport::OneWay& m) {
    const char* const done = m.backdrive ? "backdrive" : "drive";
    const char* const other = m.backdrive ? "drive" : "backdrive";
    return {
        "one_way",
        fmt::format(
            "{} has {} rows only, which cannot tell friction from an error of the torque constant. Either its torque is the stated one and "
            "mu = {}; or there is no friction and the motor gives {} of the stated torque, {}; or some of both. Measure {}: at {:.4g} Nm "
            "the "
            "capstan turns at a load of {:.4g} Nm in the first case, {:.4g} Nm in the second",
            m.side, done, with_interval(m.mu, m.mu_95), with_interval(m.scale, m.scale_95), less_or_more(m.scale), other, m.motor_torque,
            m.load_by_friction, m.load_by_scale)};
}

constexpr int kScatterPasses = 3;    // iterations of weights and lines: converged to 0.1 %
constexpr double kLargestMu = 0.95;  // limit of spring::FrictionLaw: beyond it the gear is self-locking

const char* direction_of(const BreakAway& row) { return row.backdrive ? "backdrive" : "drive"; }

/// Groups by name; none if there is only one.
template <class NameOf>
std::vector<Group> groups_by(const std::vector<BreakAway>& rows, const NameOf& name_of) {
    std::map<std::string, std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < rows.size(); ++i) members[name_of(rows[i])].push_back(i);
    std::vector<Group> groups;
    if (members.size() < 2) return groups;
    for (auto& [name, indices] : members) groups.push_back({name, std::move(indices)});
    return groups;
}

Group all_of(const std::vector<BreakAway>& rows) {
    Group all{"all", std::vector<std::size_t>(rows.size())};
    std::iota(all.rows.begin(), all.rows.end(), std::size_t{0});
    return all;
}

std::vector<FrictionLine> lines_of(const std::vector<BreakAway>& rows, const std::vector<Group>& groups,
                                   const std::vector<double>& weights) {
    std::vector<FrictionLine> lines;
    for (const Group& group : groups)
        if (const math::LinearModel model = line_model(rows, group, weights); has_line(model)) lines.push_back(fit_line(group, model));
    return lines;
}

/// Scatter of the rows about the lines of the finest groups, and the weight of each row.
struct RowWeights {
    std::vector<double> weights;
    std::vector<std::size_t> outliers;  // ascending
    Scatter scatter;
};

RowWeights weigh(const std::vector<BreakAway>& rows, const std::vector<Group>& finest) {
    RowWeights w{std::vector<double>(rows.size(), 1.0), {}, {}};
    for (int pass = 0; pass < kScatterPasses; ++pass) {
        std::vector<double> frictions, residuals, weights(rows.size(), 1.0);
        std::vector<std::pair<std::size_t, double>> expected;  // row and its friction on the line
        w.outliers.clear();
        for (const Group& group : finest) {
            const math::LinearModel model = line_model(rows, group, w.weights);
            const math::LinearFit line = math::fit_linear(model);
            const std::vector<std::size_t> outliers = outliers_of(group, math::fit_robust(model));
            for (std::size_t i = 0; i < group.rows.size(); ++i) {
                const double friction = line.coefficients[0] + line.coefficients[1] * model.instruments[1][i];
                expected.emplace_back(group.rows[i], friction);
                if (std::binary_search(outliers.begin(), outliers.end(), group.rows[i])) continue;
                frictions.push_back(friction);
                residuals.push_back(line.residuals[i]);
            }
            w.outliers.insert(w.outliers.end(), outliers.begin(), outliers.end());
        }
        w.scatter = most_likely_scatter(frictions, residuals);
        for (const auto& [row, friction] : expected) weights[row] = w.scatter.weight(friction);
        w.weights = std::move(weights);
    }
    std::sort(w.outliers.begin(), w.outliers.end());
    return w;
}

/// The groups that have a line; all rows if none has.
std::vector<Group> with_lines(const std::vector<BreakAway>& rows, std::vector<Group> groups) {
    const std::vector<double> even(rows.size(), 1.0);
    std::erase_if(groups, [&](const Group& group) { return !has_line(line_model(rows, group, even)); });
    return groups.empty() ? std::vector{all_of(rows)} : groups;
}

Group without(const Group& all, const std::vector<std::size_t>& outliers) {
    Group rest{"all without outliers", {}};
    std::set_difference(all.rows.begin(), all.rows.end(), outliers.begin(), outliers.end(), std::back_inserter(rest.rows));
    return rest;
}

std::vector<FrictionReport::Repeat> repeats_of(const std::vector<BreakAway>& rows) {
    std::map<std::tuple<std::string, bool, double>, FrictionReport::Repeat> repeats;
    const auto repeat_of = [&repeats](const BreakAway& row) -> FrictionReport::Repeat& {
        return repeats[{row.side, row.backdrive, row.motor_torque}];
    };
    for (const BreakAway& row : rows) {
        FrictionReport::Repeat& r = repeat_of(row);
        r.side = row.side;
        r.backdrive = row.backdrive;
        r.motor_torque = row.motor_torque;
        r.mean_load += row.load_torque;
        r.mean_friction += row.friction();
        ++r.rows;
    }
    for (auto& [key, r] : repeats) {
        r.mean_load /= static_cast<double>(r.rows);
        r.mean_friction /= static_cast<double>(r.rows);
    }
    for (const BreakAway& row : rows) repeat_of(row).deviation += std::pow(row.friction() - repeat_of(row).mean_friction, 2);
    std::vector<FrictionReport::Repeat> out;
    for (auto& [key, r] : repeats) {
        r.deviation = r.rows > 1 ? std::sqrt(r.deviation / static_cast<double>(r.rows - 1)) : std::numeric_limits<double>::quiet_NaN();
        out.push_back(r);
    }
    return out;
}

std::optional<FrictionReport::Law> law_of(const FrictionLine& line) {
    const bool constant = line.constant_95.low > 0.0;
    const FrictionReport::Law law = constant ? FrictionReport::Law{line.mu, line.constant} : FrictionReport::Law{line.through_zero_mu, 0.0};
    if (!(law.mu >= 0.0 && law.mu <= kLargestMu)) return std::nullopt;
    return law;
}

/// The law of the motors with both directions, with the torque that they give. Rows of one direction alone have none.
/// @param mu gets that of those rows, if there are any
void take_torques_into_account(const std::vector<BreakAway>& rows, const RowWeights& weights, FrictionReport& report, double& mu) {
    Group told{"both directions", {}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto same = [&](const auto& motor) { return motor.side == rows[i].side; };
        if (std::none_of(report.one_way.begin(), report.one_way.end(), same) &&
            !std::binary_search(weights.outliers.begin(), weights.outliers.end(), i))
            told.rows.push_back(i);
    }
    const math::LinearModel model = line_model(with_true_torques(rows, report.motors), told, weights.weights);
    report.law.reset();
    report.law_rows = told.rows.size();
    if (!has_line(model)) return;
    const FrictionLine line = fit_line(told, model);
    mu = line.mu;
    report.law = law_of(line);
}

void require_rows(const std::vector<BreakAway>& rows, const Group& all) {
    if (rows.size() < 3) throw core::InvalidInput("break-away rows", fmt::format("{}", rows.size()), "at least 3");
    if (!has_line(line_model(rows, all, std::vector<double>(rows.size(), 1.0))))
        throw core::InvalidInput("motor_torque_Nm", fmt::format("{:g} in every row", rows.front().motor_torque),
                                 "motor torques with at least two values");
}

}  // namespace

std::string FrictionReport::profile_lines() const {
    if (!law) return "";
    const std::size_t count = law_rows > 0 || lines.empty() ? law_rows : lines.front().rows;
    std::string origin = count == 0 ? "measured" : fmt::format("measured, {} break-aways", count);
    for (const Motor& motor : motors)
        if (motor.differs) origin += fmt::format("; torque of {} times {:.4g}", core::printable(motor.side, 40), motor.scale);
    std::string text = fmt::format("[rig]\ngear_friction = {:.4f}  # {}\n", law->mu, origin);
    if (law->constant > 0.0) text += fmt::format("gear_friction_constant_Nm = {:.5f}  # {}\n", law->constant, origin);
    return text;
}

FrictionReport identify_friction(const std::vector<BreakAway>& rows) {
    const Group all = all_of(rows);
    require_rows(rows, all);
    const auto by_direction = groups_by(rows, direction_of);
    const auto by_side = groups_by(rows, [](const BreakAway& row) { return row.side; });
    const auto by_both = by_direction.empty() || by_side.empty()
                             ? std::vector<Group>{}
                             : groups_by(rows, [](const BreakAway& row) { return row.side + " " + direction_of(row); });
    const std::vector<Group> finest = with_lines(rows, !by_both.empty() ? by_both : !by_side.empty() ? by_side : by_direction);
    const RowWeights row_weights = weigh(rows, finest);

    FrictionReport report;
    report.repeats = repeats_of(rows);
    report.scatter_growth = row_weights.scatter.growth;
    report.lines.push_back(fit_line(all, line_model(rows, all, row_weights.weights)));
    if (const Group rest = without(all, row_weights.outliers); rest.rows.size() < all.rows.size()) {
        const math::LinearModel model = line_model(rows, rest, row_weights.weights);
        report.outliers_left_out = has_line(model);
        if (report.outliers_left_out) report.lines.push_back(fit_line(rest, model));
    }
    const Fitted fitted{rows,
                        row_weights.weights,
                        report.trusted(),
                        lines_of(rows, by_direction, row_weights.weights),
                        lines_of(rows, by_side, row_weights.weights),
                        finest,
                        row_weights.outliers,
                        row_weights.scatter};
    for (const auto& lines : {fitted.directions, fitted.sides, lines_of(rows, by_both, row_weights.weights)})
        report.lines.insert(report.lines.end(), lines.begin(), lines.end());
    report.motors = motors_of(rows, row_weights.outliers, row_weights.weights);
    report.one_way = one_way_motors(rows, row_weights.outliers, row_weights.weights);
    report.remarks = remarks_on(fitted);
    const bool doubtful =
        !report.one_way.empty() || std::any_of(report.motors.begin(), report.motors.end(), [](const auto& motor) { return motor.differs; });
    if (doubtful) report.remarks.front().text = "with the stated torques, " + report.remarks.front().text;
    if (!report.motors.empty()) report.remarks.push_back(remark_on(report.motors));
    for (const FrictionReport::OneWay& motor : report.one_way) report.remarks.push_back(remark_on(motor));
    report.law = law_of(fitted.trusted);
    double mu = fitted.trusted.mu;
    const bool may_be_friction = report.law.has_value() && report.motors.empty();
    if (doubtful) take_torques_into_account(rows, row_weights, report, mu);
    if (!report.law && !may_be_friction)
        report.remarks.push_back(
            {"law", fmt::format("mu = {:.4g} is outside the range of a gear (0 to {:g}): no law is stated", mu, kLargestMu)});
    return report;
}

}  // namespace fusee::gap_case
