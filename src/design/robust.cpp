#include "fusee/design/robust.h"

#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/equilibrium.h"
#include "fusee/core/error.h"
#include "fusee/math/roots.h"
#include "fusee/spring/potential.h"

// Equation numbers: docs/theory/robust.md.
namespace fusee::design {

namespace {

using Eigen::Vector3d;

constexpr double kPercentile = 1.6448536269514722;  ///< 95 % of a normal distribution lie below that many standard deviations

void validate_joint(const DrawnJoint& drawn, double tau, const ShopScatter& scatter) {
    actuator::validate(drawn.actuator);
    core::require_positive("tau", tau, "Nm");
    core::require_positive("base_se.rate", drawn.base_se.rate);
    core::require_positive("base_se.preload", drawn.base_se.preload);
    core::require_positive("base_pe.rate", drawn.base_pe.rate);
    core::require_positive("base_pe.preload", drawn.base_pe.preload);
    core::require_within("scatter.rate_se", scatter.rate_se, 0.0, 0.3);  // three standard deviations below still leave a spring
    core::require_within("scatter.rate_pe", scatter.rate_pe, 0.0, 0.3);
    core::require_within("scatter.contour", scatter.contour, 0.0, 1e-2, "m");
    core::require_within("scatter.friction", scatter.friction, 0.0, 0.3);
}

/// Errors on each side of an actuator.
enum Error : std::size_t { kRateSe, kRatePe, kContourSe, kContourPe, kFriction, kErrors };
/// The member of ShopScatter that it belongs to.
constexpr std::array<std::size_t, kErrors> kSource{0, 1, 2, 2, 3};

std::array<double, kErrors> sigmas(const ShopScatter& scatter) {
    return {scatter.rate_se, scatter.rate_pe, scatter.contour, scatter.contour, scatter.friction};
}

/// Share of a normal distribution below x; of one without width, all or nothing.
double share_below(double x, double sigma) {
    if (sigma == 0.0) return x >= 0.0 ? 1.0 : 0.0;
    return 0.5 * std::erfc(-x / (sigma * std::sqrt(2.0)));
}

/// One spring at an edge of the dead-band.
struct LoadedSpring {
    Error rate, contour;
    std::size_t side;
    Vector3d jacobian_row;
    const spring::BaseSpring& base;
    double x, force, stiffness, energy;  ///< deflection and energy count from the law's lowest load

    /// dF/d(radius) at a fixed deflection, the radius being added to every arm of the cam (eq. 4, 5) [Nm/m].
    [[nodiscard]] double by_radius(double capstan_radius) const {
        const double load = base.load(energy);
        if (base.kind == spring::BaseKind::kCompression) return base.rate * x * force / load + load;
        return -((base.state(energy) - base.preload) * stiffness + force * force / load) / capstan_radius;
    }
};

std::array<LoadedSpring, 4> springs_at(const DrawnJoint& drawn, const Vector3d& z) {
    const spring::SpringLaw& law = *drawn.actuator.law;
    const double g = drawn.actuator.ratio(), x = z(actuator::kAgonist) + g * z(actuator::kOutput);
    const spring::LawPoint both = law.at_angle(x), first = law.at_angle(z(0)), second = law.at_angle(z(1));
    const auto series = [&](std::size_t side, const Vector3d& jacobian_row) -> LoadedSpring {
        return {kRateSe, kContourSe, side, jacobian_row, drawn.base_se, x, both.f_se, both.s, both.u_se};
    };
    const auto parallel = [&](std::size_t side, const Vector3d& jacobian_row, const spring::LawPoint& at) -> LoadedSpring {
        return {kRatePe, kContourPe, side, jacobian_row, drawn.base_pe, at.theta, at.f_pe, at.p, at.u_pe};
    };
    return {parallel(0, {1.0, 0.0, 0.0}, first), series(0, {1.0, 0.0, g}), series(1, {0.0, 1.0, -g}), parallel(1, {0.0, 1.0, 0.0}, second)};
}

/// The edge at which capstan 1 carries its least load and capstan 2 its greatest, and the motion of (theta_1, theta_2, q) there per
/// standard deviation of each error on each side.
struct Edge {
    Vector3d z;
    std::array<std::array<Vector3d, 2>, kErrors> moves;
};

/// theta_1, theta_2 and q from the width between the edges: F_SE(x) + F_PE(x - g q) is the least load (eq. 1).
std::optional<Vector3d> place_of(const actuator::Actuator& rig, double width, double least_load) {
    const double q = 0.5 * width, turn = rig.ratio() * q;
    const auto excess = [&](double x) { return rig.law->at_angle(x).f_se + rig.law->at_angle(x - turn).f_pe - least_load; };
    const auto x = math::bracketed_root(excess, turn, rig.law->angles().high);
    if (!x) return std::nullopt;
    return Vector3d(*x - turn, *x + turn, q);
}

/// eq. 2, 3
Edge differentiate(const DrawnJoint& drawn, const Vector3d& z, core::Range loads, const std::array<double, kErrors>& sigma) {
    const std::array<LoadedSpring, 4> springs = springs_at(drawn, z);
    Eigen::Matrix3d k = Eigen::Matrix3d::Zero();
    for (const LoadedSpring& spring : springs) k += spring.stiffness * spring.jacobian_row * spring.jacobian_row.transpose();
    const Eigen::Matrix3d m = k.inverse();
    Edge edge{.z = z, .moves = {}};
    for (const LoadedSpring& spring : springs) {
        const Vector3d per_torque = -m * spring.jacobian_row;
        edge.moves[spring.rate][spring.side] = sigma[spring.rate] * spring.force * per_torque;
        edge.moves[spring.contour][spring.side] = sigma[spring.contour] * spring.by_radius(drawn.actuator.capstan_radius) * per_torque;
    }
    const spring::FrictionLaw& gear = drawn.actuator.gear_friction;
    edge.moves[kFriction][0] = -sigma[kFriction] * gear.at_rest(loads.low) / (1.0 + gear.slope(loads.low)) * m.col(actuator::kAgonist);
    edge.moves[kFriction][1] = sigma[kFriction] * gear.at_rest(loads.high) / (1.0 - gear.slope(loads.high)) * m.col(actuator::kAntagonist);
    return edge;
}

/// Share of the built actuators whose parallel springs reach both edges: by the margins of capstan 2's law above and of capstan 1's below.
double covered_share(const Edge& edge, core::Range angles) {
    double share = 1.0;
    for (const auto& [body, left] : {std::pair{actuator::kAgonist, edge.z(actuator::kAgonist) - angles.low},
                                     {actuator::kAntagonist, angles.high - edge.z(actuator::kAntagonist)}}) {
        double variance = 0.0;
        for (const auto& sides : edge.moves)
            for (const Vector3d& move : sides) variance += move(body) * move(body);
        share *= share_below(left, std::sqrt(variance));
    }
    return share * share;
}

}  // namespace

RobustBand robust_dead_band(const DrawnJoint& drawn, double tau, const ShopScatter& scatter) {
    validate_joint(drawn, tau, scatter);
    RobustBand band{.tau = tau,
                    .nominal = core::kNan,
                    .sigma = core::kNan,
                    .band = {core::kNan, core::kNan},
                    .sources = {core::kNan, core::kNan, core::kNan, core::kNan}};
    const core::Range loads = drawn.actuator.gear_friction.resting_loads(tau);
    const double width = actuator::dead_band(drawn.actuator, tau).exact_width;
    const auto z = std::isnan(width) ? std::nullopt : place_of(drawn.actuator, width, loads.low);
    if (!z) return band;
    band.nominal = width;
    const Edge edge = differentiate(drawn, *z, loads, sigmas(scatter));
    std::array<double, 4> variances{};
    for (std::size_t i = 0; i < kErrors; ++i) {
        const double move = edge.moves[i][0](actuator::kOutput) + edge.moves[i][1](actuator::kOutput);
        variances[kSource[i]] += 2.0 * move * move;  // eq. 6; the other edge is this one's mirror image
    }
    double variance = 0.0;
    for (std::size_t i = 0; i < variances.size(); ++i) {
        variance += variances[i];
        band.sources[i] = std::sqrt(variances[i]);
    }
    band.sigma = std::sqrt(variance);
    // A dead-band is a product of scattered factors, 2 tau_f/(g P) to first order, so that its logarithm is symmetric (eq. 7).
    const double spread = band.sigma > 0.0 ? kPercentile * band.sigma / band.nominal : 0.0;
    band.band = {band.nominal * std::exp(-spread), band.nominal * std::exp(spread)};
    band.covered_share = covered_share(edge, drawn.actuator.law->angles());
    return band;
}

}  // namespace fusee::design
