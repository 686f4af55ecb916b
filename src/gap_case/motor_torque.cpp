#include "motor_torque.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "fusee/math/statistics.h"
#include "remarks.h"

namespace fusee::gap_case {

namespace {

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

}  // namespace

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

}  // namespace fusee::gap_case
