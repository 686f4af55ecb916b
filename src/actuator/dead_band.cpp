#include "fusee/actuator/dead_band.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "fusee/actuator/equilibrium.h"
#include "fusee/core/error.h"
#include "fusee/math/roots.h"
#include "settle.h"

// Equation numbers: docs/theory/dead_band.md.
namespace fusee::actuator {

namespace {

/// The resting place at the edge of the dead-band where capstan 1 carries the low load and capstan 2 the high one (eq. 5-7). The joint
/// is balanced, so both series springs are deflected by x: theta_1 = x - g q, theta_2 = x + g q.
class Edge {
public:
    Edge(const spring::SpringLaw& law, core::Range loads) : law_(law), loads_(loads), angles_(law.angles()) {}

    /// g q [rad]; nothing if a parallel spring would leave the law.
    [[nodiscard]] std::optional<double> reach() const {
        if (loads_.width() == 0.0) return 0.0;
        const std::optional<double> near = by_newton();
        return near ? near : by_bracket();
    }

private:
    /// Newton's method on (6) in (x, g q), several times as fast as the bracket; a step that would leave the law stops before its end.
    /// Nothing if it does not converge: the edge lies beyond the law, or nearly.
    [[nodiscard]] std::optional<double> by_newton() const {
        constexpr int kMostSteps = 12;
        constexpr double kBalanced = 1e-13, kShortOfEnd = 0.9;
        double x = 0.5 * (law_.at_load(loads_.low).theta + law_.at_load(loads_.high).theta), reach = 0.0;
        for (int i = 0; i < kMostSteps; ++i) {
            const spring::LawPoint se = law_.at_angle(x), low = law_.at_angle(x - reach), high = law_.at_angle(x + reach);
            const double left_low = se.f_se + low.f_pe - loads_.low, left_high = se.f_se + high.f_pe - loads_.high;
            if (std::max(std::abs(left_low), std::abs(left_high)) <= kBalanced * loads_.high) return reach;
            const double determinant = (se.s + low.p) * high.p + (se.s + high.p) * low.p;
            const double step = -(high.p * left_low + low.p * left_high) / determinant;
            const double wider = -((se.s + low.p) * left_high - (se.s + high.p) * left_low) / determinant;
            const double down = (x - reach - angles_.low) / (wider - step), up = (angles_.high - x - reach) / (wider + step);
            double share = 1.0;
            if (wider > step) share = std::min(share, kShortOfEnd * down);
            if (wider > -step) share = std::min(share, kShortOfEnd * up);
            x += share * step;
            reach += share * wider;
        }
        return std::nullopt;
    }

    /// eq. 7, if Newton's method does not converge.
    [[nodiscard]] std::optional<double> by_bracket() const {
        const double low = law_.at_load(loads_.low).theta, high = law_.at_load(loads_.high).theta;
        const auto x = math::bracketed_root([this](double at) { return excess(at); }, low, high);
        if (!x) return std::nullopt;
        const std::optional<double> theta_1 = low_side(*x);
        if (!theta_1 || 2.0 * *x - *theta_1 > angles_.high) return std::nullopt;
        return *x - *theta_1;
    }

    /// theta_1 from F_PE(theta_1) + F_SE(x) = low load.
    [[nodiscard]] std::optional<double> low_side(double x) const {
        const double wanted = loads_.low - law_.at_angle(x).f_se;
        const auto beyond = [&](double theta) { return law_.at_angle(theta).f_pe - wanted; };
        if (beyond(x) <= 0.0) return x;  // up to rounding, x is where the law carries the low load: theta_1 = x
        return math::bracketed_root(beyond, angles_.low, x);
    }

    /// F_PE(theta_2) + F_SE(x) - high load: rises with x. Springs are clamped to the law's ends; reach() refuses a root found there.
    [[nodiscard]] double excess(double x) const {
        const double theta_2 = 2.0 * x - low_side(x).value_or(angles_.low);
        return law_.at_angle(theta_2).f_pe + law_.at_angle(x).f_se - loads_.high;
    }

    const spring::SpringLaw& law_;
    core::Range loads_, angles_;
};

/// Full width at the joint, eq. 7; nothing if stiction allows loads that the law does not cover.
std::optional<double> exact_width_at(const Actuator& actuator, double tau) {
    const core::Range loads = actuator.gear_friction.resting_loads(tau);
    const core::Range covered = actuator.law->loads();
    if (!covered.holds(loads.low) || !covered.holds(loads.high)) return std::nullopt;
    const std::optional<double> reach = Edge(*actuator.law, loads).reach();
    if (!reach) return std::nullopt;
    return 2.0 * *reach / actuator.ratio();
}

/// eq. 4: d(T tau_f)/dtau along equal co-contraction, where dtau/dtheta = S + P.
double condition_6(const spring::LawPoint& p, const spring::FrictionLaw& friction) {
    const double sum = p.s + p.p;
    const double transmission_slope = (p.s_slope * p.p - p.s * p.p_slope) / (sum * sum * sum);
    return p.transmission() * friction.slope(p.tau) + friction.at_rest(p.tau) * transmission_slope;
}

/// Derivative of the stiffness matrix as the bodies move along `way`.
Eigen::Matrix3d stiffness_slope(const Joint& joint, const Eigen::Vector3d& z, const Eigen::Vector3d& way) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const JointSpring& spring : joint.springs)
        sum += spring.potential->slope(deflection(spring, z)) * spring.jacobian_row.dot(way) * spring.jacobian_row *
               spring.jacobian_row.transpose();
    return sum;
}

/// eq. 10, 11: d(T tau_f)/dtau of one side while the bodies move along `way` for each Nm.
double condition(const Joint& joint, const JointDeadBand& band, const Eigen::Matrix3d& m, int side, double tau,
                 const Eigen::Vector3d& way) {
    const spring::FrictionLaw& friction = joint.gear_friction[static_cast<std::size_t>(side)];
    const Eigen::Matrix3d change = -m * stiffness_slope(joint, band.z, way) * m;
    const double own = m(kOutput, side), all = m(kOutput, kOutput), share = std::copysign(1.0 / joint.ratio(), own);
    const double transmission = share * own / all;
    const double slope = share * (change(kOutput, side) - own / all * change(kOutput, kOutput)) / all;
    return slope * friction.at_rest(tau) + transmission * friction.slope(tau);
}

JointDeadBand nowhere() {
    JointDeadBand band;
    band.z.setConstant(core::kNan);
    band.linear = band.exact_width = band.edges.low = band.edges.high = band.joint_stiffness = band.free_joint_stiffness = core::kNan;
    band.condition_5 = band.condition_6 = {core::kNan, core::kNan};
    band.covered = false;
    return band;
}

/// q where each capstan carries the end of its resting loads that moves the output to `side` (-1 or 1).
double edge(const Joint& joint, const std::array<core::Range, 2>& loads, const JointDeadBand& band, const Eigen::Matrix3d& m, int side) {
    Eigen::Vector3d torque = Eigen::Vector3d::Zero();
    for (int i = 0; i < 2; ++i) {
        const core::Range& range = loads[static_cast<std::size_t>(i)];
        torque[i] = m(kOutput, i) * side > 0.0 ? range.high : range.low;
    }
    const auto rest = equilibrium(joint, torque, band.z);
    return rest ? rest->z[kOutput] : core::kNan;
}

}  // namespace

DeadBand dead_band(const Actuator& actuator, double tau) {
    DeadBand band;
    band.tau = tau;
    const std::optional<double> exact = exact_width_at(actuator, tau);
    band.covered = exact.has_value();
    band.exact_width = exact.value_or(core::kNan);
    if (!actuator.law->loads().holds(tau)) {
        band.linear = band.joint_stiffness = band.free_joint_stiffness = band.theta = band.condition_6 = core::kNan;
        return band;
    }
    const spring::LawPoint p = actuator.law->at_load(tau);
    const double g = actuator.ratio();
    band.linear = 2.0 * actuator.gear_friction.at_rest(tau) / (g * p.p);
    band.joint_stiffness = 2.0 * g * g * p.s;
    band.free_joint_stiffness = band.joint_stiffness * p.p / (p.s + p.p);
    band.theta = p.theta;
    band.condition_6 = condition_6(p, actuator.gear_friction);
    return band;
}

std::vector<DeadBand> dead_band_curve(const Actuator& actuator, std::size_t count) {
    if (count < 2) throw core::InvalidInput("count", fmt::format("{}", count), "at least 2 levels");
    std::vector<DeadBand> curve;
    curve.reserve(count);
    const core::Range torques{actuator.least_torque, actuator.overdrive_torque};
    for (std::size_t i = 0; i < count; ++i) curve.push_back(dead_band(actuator, torques.level(i, count)));
    return curve;
}

ConditionSummary summarize_condition(const Actuator& actuator) {
    constexpr int kScan = 400;
    const core::Range covered = actuator.law->loads();
    ConditionSummary summary;
    summary.torques = {std::max(actuator.least_torque, covered.low), std::min(actuator.overdrive_torque, covered.high)};
    summary.values = {core::kNan, core::kNan};
    if (summary.torques.width() < 0.0) return summary;
    const auto condition = [&](double tau) { return condition_6(actuator.law->at_load(tau), actuator.gear_friction); };
    double earlier = summary.torques.low, before = condition(earlier);
    summary.values = {before, before};
    if (before < 0.0) summary.holds.push_back({earlier, earlier});
    for (int i = 1; i <= kScan; ++i) {
        const double tau = summary.torques.low + summary.torques.width() * i / kScan, now = condition(tau);
        const bool changed = (now < 0.0) != (before < 0.0);
        const double from = changed ? math::bracketed_root(condition, earlier, tau).value_or(tau) : earlier;
        if (changed && now < 0.0) summary.holds.push_back({from, tau});
        if (before < 0.0) summary.holds.back().high = changed ? from : tau;
        summary.values = {std::min(summary.values.low, now), std::max(summary.values.high, now)};
        earlier = tau;
        before = now;
    }
    return summary;
}

JointDeadBand joint_dead_band(const Joint& joint, double tau_1, double tau_2) {
    const Eigen::Vector3d torque(tau_1, tau_2, 0.0);
    const auto rest = equilibrium(joint, torque);
    if (!rest) return nowhere();
    JointDeadBand band;
    band.z = rest->z;
    const Eigen::Matrix3d m = sensitivity(joint, band.z).value();
    std::array<core::Range, 2> loads;
    for (int i = 0; i < 2; ++i) {
        const auto at = static_cast<std::size_t>(i);
        loads[at] = joint.gear_friction[at].resting_loads(torque[i]);
        band.linear += std::abs(m(kOutput, i)) * 2.0 * joint.gear_friction[at].at_rest(torque[i]);
        band.condition_5[at] = condition(joint, band, m, i, torque[i], m.col(i));
        band.condition_6[at] = condition(joint, band, m, i, torque[i], m.col(kAgonist) + m.col(kAntagonist));
    }
    band.edges = {edge(joint, loads, band, m, -1), edge(joint, loads, band, m, 1)};
    band.exact_width = band.edges.width();
    band.covered = !std::isnan(band.exact_width);
    band.joint_stiffness = stiffness(joint, band.z)(kOutput, kOutput);
    band.free_joint_stiffness = 1.0 / m(kOutput, kOutput);
    return band;
}

}  // namespace fusee::actuator
