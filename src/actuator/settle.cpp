#include "settle.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace fusee::actuator {

namespace {

constexpr int kMostSteps = 200;           ///< a dozen is usual
constexpr double kLongestDescent = 10.0;  ///< first step [rad]; extended while the energy falls
constexpr double kFarAway = 1e6;          ///< [rad]: no spring holds a body there
constexpr double kSettled = 1e-14;        ///< of the torques that act on a body
constexpr double kSettling = 1e-10;       ///< below this share a step that does not halve the residual is rounding
constexpr double kSteep = 1e200;          ///< stands for a torque that overflows

bool frozen(const Joint& joint, int body) { return joint.frozen[static_cast<std::size_t>(body)]; }

/// Remaining torque; 0 at frozen bodies, which are supported.
Eigen::Vector3d borne_by_motion(const Joint& joint, Eigen::Vector3d torques) {
    for (int body = 0; body < 3; ++body)
        if (frozen(joint, body)) torques[body] = 0.0;
    return torques;
}

/// The torques at a place.
struct Balance {
    Eigen::Vector3d rest;  ///< what no spring balances
    double scale = 0.0;    ///< the largest that acts on a body
};

Balance balance(const Joint& joint, const Eigen::Vector3d& torque, const Eigen::Vector3d& z) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double largest = borne_by_motion(joint, torque).lpNorm<Eigen::Infinity>();
    for (const JointSpring& spring : joint.springs) {
        const double force = spring.potential->force(deflection(spring, z));
        sum += force * spring.jacobian_row;
        largest = std::max(largest, std::abs(force) * spring.jacobian_row.lpNorm<Eigen::Infinity>());
    }
    return {borne_by_motion(joint, sum - torque), largest};
}

/// Newton's direction; a downhill one even if stiffness is zero or negative.
Eigen::Vector3d direction(const Joint& joint, const Eigen::Vector3d& z, const Eigen::Vector3d& rest) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(free_stiffness(joint, z));
    const double largest = modes.eigenvalues().cwiseAbs().maxCoeff();
    const double floor = std::max(1e-12 * largest, 1e-12 * rest.lpNorm<Eigen::Infinity>());
    const Eigen::Vector3d stiffness = modes.eigenvalues().cwiseAbs().cwiseMax(floor);
    Eigen::Vector3d step = -(modes.eigenvectors() * (modes.eigenvectors().transpose() * rest).cwiseQuotient(stiffness));
    const double length = step.norm();
    if (length > kLongestDescent) step *= kLongestDescent / length;
    return step;
}

/// Length, in steps, to about the least energy: where the slope is a tenth of the first one. `longest` if the energy falls all the way.
/// @param slope of the energy along the way, rising; `first` < 0 is where it begins
template <class Slope>
double step_length(const Slope& slope, double first, double longest) {
    double low = 0.0, low_slope = first, high = 0.0, high_slope = 0.0, length = 1.0;  // high = 0: not known yet
    while (length < longest) {
        const double here = slope(length);
        if (std::abs(here) <= 0.1 * std::abs(first)) return length;
        (here > 0.0 ? high : low) = length;
        (here > 0.0 ? high_slope : low_slope) = here;
        if (high == 0.0) {
            length *= 2.0;
            continue;
        }
        // The secant, kept away from the bracket's ends: on a steep stop behind a soft spring it converges slowly.
        const double width = high - low;
        length = std::clamp(low - low_slope * width / (high_slope - low_slope), low + 0.1 * width, high - 0.1 * width);
        if (!(length > low && length < high)) return high_slope < -low_slope ? high : low;
    }
    return longest;
}

/// A start at which no torque overflows.
Eigen::Vector3d finite_start(const Joint& joint, const Eigen::Vector3d& start) {
    Eigen::Vector3d z = start;
    for (int i = 0; i < kMostSteps && !(spring_torques(joint, z).lpNorm<Eigen::Infinity>() < kSteep); ++i)
        for (int body = 0; body < 3; ++body)
            if (!frozen(joint, body)) z[body] *= 0.5;
    return z;
}

}  // namespace

Eigen::Matrix3d free_stiffness(const Joint& joint, const Eigen::Vector3d& z) {
    Eigen::Matrix3d matrix = stiffness(joint, z);
    for (int body = 0; body < 3; ++body)
        if (frozen(joint, body)) {
            matrix.row(body).setZero();
            matrix.col(body).setZero();
        }
    const double largest = matrix.diagonal().maxCoeff();
    for (int body = 0; body < 3; ++body)
        if (frozen(joint, body)) matrix(body, body) = largest > 0.0 ? largest : 1.0;
    return matrix;
}

Settled settle(const Joint& joint, const Eigen::Vector3d& torque, const Eigen::Vector3d& start) {
    Settled now;
    now.z = finite_start(joint, start);
    Balance here = balance(joint, torque, now.z);
    const auto measure = [&] { now.residual = here.rest.lpNorm<Eigen::Infinity>(), now.scale = here.scale; };
    for (measure(); now.steps < kMostSteps && !now.ran_away && now.residual > kSettled * now.scale; ++now.steps) {
        const Eigen::Vector3d step = direction(joint, now.z, here.rest);
        Balance next;  // where the slope was asked for last
        double asked = 0.0;
        const auto slope = [&](double t) {
            next = balance(joint, torque, now.z + t * step), asked = t;
            const double along = next.rest.dot(step);
            return std::isnan(along) ? kSteep : std::clamp(along, -kSteep, kSteep);
        };
        const double longest = kFarAway / step.norm(), length_factor = step_length(slope, here.rest.dot(step), longest);
        now.ran_away = length_factor == longest;
        if (asked != length_factor) (void)slope(length_factor);
        if (now.residual <= kSettling * now.scale && !(next.rest.lpNorm<Eigen::Infinity>() < 0.5 * now.residual)) break;
        now.z += length_factor * step;
        here = next;
        measure();
    }
    return now;
}

}  // namespace fusee::actuator
