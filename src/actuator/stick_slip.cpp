#include "fusee/actuator/stick_slip.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/core/error.h"

// Equation numbers: docs/theory/stick_slip.md.

namespace fusee::actuator {

namespace {

/// Spring torques dU/dz between which a body stays: it turns up while its torque is `low`, down while it is `high`. [Nm], low <= high.
struct PlayLimits {
    Eigen::Vector3d low, high;
};

struct RestingPlace {
    Eigen::Vector3d z;  ///< [rad]
    bool held = true;   ///< false: no spring stops the motion; z is where the search ended
};

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kMostIterations = 200;     ///< Newton's steps; three are typical
constexpr double kTolerance = 1e-11;     ///< remaining torque, of the greatest limit (at least 1 Nm)
constexpr double kLeastStep = 1e-15;     ///< step relative to the place, near the resolution of doubles
constexpr double kFlat = 1e-9;           ///< added to the stiffness of the Newton step [Nm/rad]: with all cables slack U has none
constexpr double kLongestStep = 1.0;     ///< of one Newton step [rad]
constexpr double kRunaway = 1e4;         ///< no spring holds a body that has turned so far [rad]
constexpr double kEnoughDecrease = 0.5;  ///< of the slope along a step

/// Least of the convex energy of eq. 3 by Newton's steps on the bodies that move. A step ends where a body returns to its start, and
/// otherwise where the slope along it is about 0: no energy is evaluated, slopes of a convex function suffice.
class Search {
public:
    Search(const Joint& joint, const PlayLimits& limits, const Vector3d& from, const Vector3d& guess)
        : joint_(joint), limits_(limits), from_(from), z_(guess), loads_(spring_torques(joint, guess)) {
        tolerance_ = kTolerance * std::max({1.0, limits.low.cwiseAbs().maxCoeff(), limits.high.cwiseAbs().maxCoeff()});
    }

    RestingPlace run() {
        for (int i = 0; i < kMostIterations; ++i) {
            const Vector3d pull = unbalanced();
            if (pull.cwiseAbs().maxCoeff() <= tolerance_) return {z_, true};
            if ((z_ - from_).cwiseAbs().maxCoeff() > kRunaway) return {z_, false};
            const Vector3d step = newton_step(pull);
            const bool lost_in_rounding = step.cwiseAbs().maxCoeff() <= kLeastStep * z_.cwiseAbs().maxCoeff();
            if (lost_in_rounding || !advance(step)) return {z_, true};
        }
        return {z_, false};
    }

private:
    [[nodiscard]] bool at_start(int i) const { return z_[i] == from_[i]; }
    [[nodiscard]] bool without_friction(int i) const { return limits_.low[i] == limits_.high[i]; }

    /// Spring torque beyond the limit at which each body moves, eq. 2; 0 for one that may stay.
    [[nodiscard]] Vector3d unbalanced() const {
        Vector3d pull = Vector3d::Zero();
        for (int i = 0; i < 3; ++i) {
            if (joint_.frozen[i]) continue;
            const double below = loads_[i] - limits_.low[i], above = loads_[i] - limits_.high[i];
            if (at_start(i))
                pull[i] = below < 0.0 ? below : std::max(above, 0.0);
            else
                pull[i] = z_[i] > from_[i] ? below : above;
        }
        return pull;
    }

    /// Newton's step of the bodies that are pulled or already moving. A body that would move against its pull stays, and the others step
    /// without it: at least one moves with its pull, because stiffness is positive.
    [[nodiscard]] Vector3d newton_step(Vector3d pull) const {
        const Matrix3d stiff = stiffness(joint_, z_);
        std::array<bool, 3> moves{};
        for (int i = 0; i < 3; ++i) moves[i] = !joint_.frozen[i] && (pull[i] != 0.0 || !at_start(i));
        for (;;) {
            Matrix3d matrix = Matrix3d::Identity();
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    if (moves[i] && moves[j]) matrix(i, j) = stiff(i, j) + (i == j ? kFlat : 0.0);
            const Vector3d step = -matrix.ldlt().solve(pull);
            bool agrees = true;
            for (int i = 0; i < 3; ++i) {
                if (!moves[i] || !at_start(i) || without_friction(i) || step[i] * pull[i] < 0.0) continue;
                moves[i] = agrees = false;
                pull[i] = 0.0;
            }
            if (agrees) return step * std::min(1.0, kLongestStep / step.cwiseAbs().maxCoeff());
        }
    }

    /// The limit of body i in a step: of the side on which it is, or to which it moves.
    [[nodiscard]] double limit(int i, double step) const {
        const double side = at_start(i) ? step : z_[i] - from_[i];
        return side > 0.0 ? limits_.low[i] : limits_.high[i];
    }

    /// A step and its greatest length.
    struct Line {
        Vector3d start, step;
        Vector3d against = Vector3d::Zero();                       ///< the limit of each body during the step [Nm]
        double longest = std::numeric_limits<double>::infinity();  ///< share of the step at which a body returns to its start
        int returning = -1;                                        ///< that body
    };
    [[nodiscard]] Line line_along(const Vector3d& step) const {
        Line line{z_, step};
        for (int i = 0; i < 3; ++i) {
            if (step[i] == 0.0) continue;
            line.against[i] = limit(i, step[i]);
            const double home = (from_[i] - z_[i]) / step[i];
            if (without_friction(i) || home <= 0.0 || home > line.longest) continue;
            line.longest = home;
            line.returning = i;
        }
        return line;
    }

    /// Moves to `share` of the step. @return the slope of the energy there
    double go(const Line& line, double share) {
        z_ = line.start + share * line.step;
        if (share == line.longest) z_[line.returning] = from_[line.returning];
        loads_ = spring_torques(joint_, z_);
        return (loads_ - line.against).dot(line.step);
    }

    bool advance(const Vector3d& step);

    const Joint& joint_;
    const PlayLimits& limits_;
    const Vector3d& from_;
    Vector3d z_, loads_;
    double tolerance_;
};

/// Moves along `step` to about its least energy. False if the energy does not fall.
bool Search::advance(const Vector3d& step) {
    const Line line = line_along(step);
    const double slope = (loads_ - line.against).dot(step);
    if (!(slope < 0.0)) return false;
    const double farthest = std::min(line.longest, kRunaway / step.cwiseAbs().maxCoeff());
    double low = 0.0, low_slope = slope, high = 0.0, high_slope = 0.0;  // high = 0: not known yet
    double share = std::min(1.0, farthest);
    for (;;) {
        const double here = go(line, share);
        if (std::abs(here) <= -kEnoughDecrease * slope || (here < 0.0 && share == farthest)) break;
        (here < 0.0 ? low : high) = share;
        (here < 0.0 ? low_slope : high_slope) = here;
        if (high == 0.0) {
            share = std::min(farthest, 2.0 * share);
            continue;
        }
        // The secant, kept away from the bracket's ends: on a steep stop behind a soft spring it converges slowly.
        const double width = high - low;
        share = std::clamp(low - low_slope * width / (high_slope - low_slope), low + 0.1 * width, high - 0.1 * width);
        if (!(share > low && share < high)) break;
    }
    return z_ != line.start;
}

/// Resting place of a joint that starts at `from`: the least of U(z) + sum_i max(-low_i d_i, -high_i d_i), d = z - from
/// (docs/theory/stick_slip.md, eq. 3). Bodies that stay keep exactly their place in `from`.
/// @param guess start of the search: the nearer, the faster
RestingPlace find_resting_place(const Joint& joint, const PlayLimits& limits, const Vector3d& from, const Vector3d& guess) {
    return Search(joint, limits, from, guess).run();
}

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
