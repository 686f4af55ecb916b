#include "fusee/spring/friction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/core/error.h"
#include "fusee/math/interval.h"
#include "fusee/math/roots.h"

// Equation numbers: docs/theory/friction.md.
namespace fusee::spring {

namespace {

/// A gear whose friction grows as fast as its load cannot be driven back.
constexpr double kSteepest = 0.95;
constexpr double kLargestTorque = 1e6;

void require_rows(const std::vector<double>& loads, const std::vector<double>& torques) {
    if (loads.size() < 2 || loads.size() != torques.size())
        throw core::InvalidInput("friction table", fmt::format("{} loads, {} torques", loads.size(), torques.size()),
                                 "as many torques as loads, at least 2");
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const double lowest = i == 0 ? 0.0 : std::nextafter(loads[i - 1], kLargestTorque);
        core::require_within(fmt::format("friction table, row {}: load_Nm", i + 1), loads[i], lowest, kLargestTorque, "Nm, rising");
        core::require_within(fmt::format("friction table, row {}: friction_Nm", i + 1), torques[i], 0.0, kLargestTorque, "Nm");
    }
}

/// Slopes of the monotone cubic through the rows (Fritsch & Butland 1984); one-sided differences at both ends.
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y) {
    const std::size_t n = x.size();
    const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
    std::vector<double> slopes(n);
    slopes.front() = secant(0);
    slopes.back() = secant(n - 2);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double left = secant(i - 1), right = secant(i);
        if (left * right <= 0.0) continue;
        const double h0 = x[i] - x[i - 1], h1 = x[i + 1] - x[i], w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
        slopes[i] = (w0 + w1) / (w0 / left + w1 / right);
    }
    return slopes;
}

/// Greatest |slope| of a cubic between two rows: its slope is a parabola, steepest at an end or at the vertex.
double steepest_between(double left, double right, double secant) {
    const double second = left + right - 2.0 * secant;  // slope(t) = left + 2 (3 secant - 2 left - right) t + 3 second t^2
    const double vertex = second == 0.0 ? 0.0 : (2.0 * left + right - 3.0 * secant) / (3.0 * second);
    const double steepest = std::max(std::abs(left), std::abs(right));
    if (!(vertex > 0.0 && vertex < 1.0)) return steepest;
    return std::max(steepest, std::abs(left - 3.0 * second * vertex * vertex));
}

/// The load at which load + sign * tau_f(load) is the motor's torque; it rises with the load, since tau_f is flatter than 1.
template <class Friction>
double balanced_load(double motor_torque, double sign, const Friction& tau_f) {
    const auto excess = [&](double load) { return load + sign * tau_f(load) - motor_torque; };
    double reach = std::abs(motor_torque) + tau_f(motor_torque) + 1e-9;
    while (excess(motor_torque - reach) > 0.0 || excess(motor_torque + reach) < 0.0) reach *= 2.0;
    return math::bracketed_root(excess, motor_torque - reach, motor_torque + reach).value_or(std::numeric_limits<double>::quiet_NaN());
}

/// eq. 3: load + constant + mu |load| = motor torque .. load - constant - mu |load| = motor torque.
core::Range balanced_loads(double motor_torque, double constant, double mu) {
    const double low = motor_torque - constant, high = motor_torque + constant;
    return {low / (low >= 0.0 ? 1.0 + mu : 1.0 - mu), high / (high >= 0.0 ? 1.0 - mu : 1.0 + mu)};
}

}  // namespace

FrictionLaw FrictionLaw::proportional(double mu) { return affine(0.0, mu, 0.0); }

FrictionLaw FrictionLaw::affine(double constant, double mu, double rest_excess) {
    core::require_within("friction.constant", constant, 0.0, kLargestTorque, "Nm");
    core::require_within("friction.rest_excess", rest_excess, 0.0, 10.0);
    core::require_within("friction.mu", mu, 0.0, kSteepest / (1.0 + rest_excess));
    FrictionLaw law;
    law.constant_ = constant;
    law.mu_ = mu;
    law.rest_excess_ = rest_excess;
    return law;
}

FrictionLaw FrictionLaw::tabulated(std::vector<double> loads, std::vector<double> torques, double rest_excess) {
    core::require_within("friction.rest_excess", rest_excess, 0.0, 10.0);
    require_rows(loads, torques);
    FrictionLaw law;
    law.slopes_ = monotone_slopes(loads, torques);
    law.loads_ = std::move(loads);
    law.torques_ = std::move(torques);
    law.rest_excess_ = rest_excess;
    for (std::size_t i = 0; i + 1 < law.loads_.size(); ++i) {
        const double secant = (law.torques_[i + 1] - law.torques_[i]) / (law.loads_[i + 1] - law.loads_[i]);
        const double steepest = steepest_between(law.slopes_[i], law.slopes_[i + 1], secant);
        if ((1.0 + rest_excess) * steepest > kSteepest)
            throw core::InvalidInput(
                fmt::format("friction table, row {}: friction_Nm", i + 2), fmt::format("slope {:.3g}", steepest),
                fmt::format("at most {:.3g} Nm per Nm of load: a steeper gear locks itself", kSteepest / (1.0 + rest_excess)));
    }
    return law;
}

/// A table's cubic between two rows, the end slopes' lines beyond them; below 0 outside a falling end, cut off by the callers.
/// @param within a load between the same rows as `size`, or `size` itself
template <class T>
FrictionLaw::LineOf<T> FrictionLaw::interpolate(const T& size, double within) const {
    const std::size_t last = loads_.size() - 1;
    if (within < loads_.front()) return {torques_.front() - slopes_.front() * (loads_.front() - size), slopes_.front()};
    if (within >= loads_.back()) return {torques_[last] + slopes_[last] * (size - loads_[last]), slopes_[last]};
    const auto i = static_cast<std::size_t>(std::upper_bound(loads_.begin(), loads_.end(), within) - loads_.begin()) - 1;
    const double h = loads_[i + 1] - loads_[i];
    const T t = (size - loads_[i]) / h, s = 1.0 - t;
    return {torques_[i] * s * s * (1.0 + 2.0 * t) + torques_[i + 1] * t * t * (3.0 - 2.0 * t) +
                h * s * t * (slopes_[i] * s - slopes_[i + 1] * t),
            6.0 * s * t * (torques_[i + 1] - torques_[i]) / h + slopes_[i] * s * (1.0 - 3.0 * t) + slopes_[i + 1] * t * (1.0 - 3.0 * s)};
}

double FrictionLaw::in_motion(double load) const {
    const double size = std::abs(load);
    return loads_.empty() ? constant_ + mu_ * size : std::max(0.0, interpolate(size, size).value);
}

double FrictionLaw::at_rest(double load) const { return (1.0 + rest_excess_) * in_motion(load); }

double FrictionLaw::slope(double load) const {
    if (loads_.empty()) return (1.0 + rest_excess_) * mu_;
    const double size = std::abs(load);
    const Line line = interpolate(size, size);
    const bool cut_off = line.value < 0.0 || (line.value == 0.0 && line.slope < 0.0);
    return cut_off ? 0.0 : (1.0 + rest_excess_) * line.slope;
}

math::Jet FrictionLaw::at_rest(const math::Jet& load) const {
    const math::Jet in_motion = loads_.empty() ? constant_ + mu_ * load : interpolate(load, math::middle(load.value)).value;
    if (!(in_motion.value.lower() > 0.0)) return math::Jet::anything();  // it has a kink where it is cut off
    return (1.0 + rest_excess_) * in_motion;
}

math::Jet FrictionLaw::slope(const math::Jet& load) const {
    return (1.0 + rest_excess_) * (loads_.empty() ? math::Jet(mu_) : interpolate(load, math::middle(load.value)).slope);
}

core::Range FrictionLaw::balanced(double motor_torque, double excess) const {
    const double share = 1.0 + excess;
    if (loads_.empty()) return balanced_loads(motor_torque, share * constant_, share * mu_);
    const auto tau_f = [&](double load) { return share * in_motion(load); };
    return {balanced_load(motor_torque, 1.0, tau_f), balanced_load(motor_torque, -1.0, tau_f)};
}

core::Range FrictionLaw::resting_loads(double motor_torque) const { return balanced(motor_torque, rest_excess_); }
core::Range FrictionLaw::moving_loads(double motor_torque) const { return balanced(motor_torque, 0.0); }

bool FrictionLaw::is_proportional() const { return loads_.empty() && constant_ == 0.0; }

core::Range resting_loads(const FrictionLaw& gear, double motor_torque, double factor) {
    const auto edge = [&](double sign) {
        const auto excess = [&](double load) { return load + sign * factor * gear.at_rest(load) - motor_torque; };
        double reach = motor_torque;
        while (sign < 0.0 && excess(reach) < 0.0 && reach < 1e3 * motor_torque) reach *= 2.0;
        return math::bracketed_root(excess, sign > 0.0 ? -motor_torque : 0.0, reach).value_or(core::kNan);
    };
    return {edge(1.0), edge(-1.0)};
}

}  // namespace fusee::spring
