#include "fusee/actuator/stick_slip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "stick_slip_place.h"

// Equation numbers: docs/theory/stick_slip.md.
namespace fusee::actuator {

namespace {

using Eigen::Vector3d;

/// Rounding of a place at the end of a law [rad].
constexpr double kInside = 1e-9;
/// Iterations of one step: one for each break-away and each change of the bearing's tension.
constexpr int kMostRounds = 60;
/// Relative change of the bearing's friction that is ignored.
constexpr double kSameBearing = 1e-12;

/// eq. 4: the bearing's friction under its tension at z [Nm]
double bearing_friction(const Joint& joint, const Vector3d& z) {
    const OutputFriction& friction = joint.output_friction;
    if (friction.tension_share == 0.0) return friction.constant;
    double tension = 0.0;
    for (const JointSpring& spring : joint.springs) {
        const double arm = std::abs(spring.jacobian_row[kOutput]);
        if (arm > 0.0) tension += arm * spring.potential->force(spring.offset + spring.jacobian_row.dot(z));
    }
    return friction.constant + friction.tension_share * std::max(tension, 0.0);
}

/// eq. 1: the torque that each body carries without moving further: friction in motion if it slides, at rest otherwise.
PlayLimits limits_of(const Joint& joint, const Vector3d& torque, const Vector3d& sliding, double bearing) {
    PlayLimits limits{torque, torque};
    for (const int i : {kAgonist, kAntagonist}) {
        const spring::FrictionLaw& law = joint.gear_friction[i];
        const core::Range rest = law.resting_loads(torque[i]);
        limits.low[i] = rest.low;
        limits.high[i] = rest.high;
        if (sliding[i] == 0.0) continue;
        const core::Range motion = law.moving_loads(torque[i]);
        if (sliding[i] > 0.0)
            limits.low[i] = motion.low;
        else
            limits.high[i] = motion.high;
    }
    limits.low[kOutput] -= bearing;
    limits.high[kOutput] += bearing;
    return limits;
}

/// A spring beyond the end of its law; a slack one, or one on its preload stop, is inside.
bool beyond_end(const Joint& joint, const Vector3d& z) {
    return std::any_of(joint.springs.begin(), joint.springs.end(), [&](const JointSpring& spring) {
        return spring.offset + spring.jacobian_row.dot(z) > spring.potential->domain().high + kInside;
    });
}

}  // namespace

StickSlip::StickSlip(Joint joint, const Vector3d& z) : joint_(std::move(joint)), z_(z) {}

void StickSlip::lead_to(const Vector3d& torque, int steps) {
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(torque[i]))
            throw core::InvalidInput(fmt::format("torque[{}]", i), fmt::format("{:g}", torque[i]), "a finite torque in Nm");
    if (steps < 1) throw core::InvalidInput("steps", fmt::format("{}", steps), "at least 1");
    const Vector3d start = torque_;
    Vector3d stride = Vector3d::Zero();
    for (int i = 1; i <= steps; ++i) {
        const Vector3d before = z_;
        step(i == steps ? torque : start + (torque - start) * i / steps, z_ + stride);
        stride = z_ - before;
    }
}

void StickSlip::step(const Vector3d& torque, const Vector3d& guess) {
    Vector3d sliding = sliding_;
    double bearing = bearing_friction(joint_, z_);
    RestingPlace place{guess};
    for (int round = 0; round < kMostRounds; ++round) {
        const PlayLimits limits = limits_of(joint_, torque, sliding, bearing);
        place = find_resting_place(joint_, limits, z_, place.z);
        const Vector3d moved = (place.z - z_).cwiseSign();
        const double now = bearing_friction(joint_, place.z);
        const bool settled =
            (moved.array() == 0.0 || moved.array() == sliding.array()).all() && std::abs(now - bearing) <= kSameBearing * now;
        bearing = now;
        for (int i = 0; i < 3; ++i)
            if (moved[i] != 0.0) sliding[i] = moved[i];
        if (settled) break;
    }
    held_ = held_ && place.held;
    inside_ = inside_ && place.held && !beyond_end(joint_, place.z);
    if (!place.held) place.z = z_;  // only a stop, which is not modelled, would catch it
    sliding_ = (place.z - z_).cwiseSign();
    z_ = place.z;
    torque_ = torque;
}

}  // namespace fusee::actuator
