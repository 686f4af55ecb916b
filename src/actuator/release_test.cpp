#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "fusee/actuator/stick_slip.h"
#include "fusee/core/error.h"

namespace fusee::actuator {

namespace {

constexpr int kSearchSteps = 6;          ///< of each stroke during the search for a push: the reading hardly depends on them
constexpr int kMostDoublings = 24;       ///< of the push, from kFirstPush
constexpr double kFirstPush = 1.0 / 64;  ///< of g tau
constexpr double kPushDigits = 1e-4;     ///< relative width of the bracket of a push
constexpr double kSameReading = 1e-3;    ///< relative change of the width that is ignored
constexpr double kFullPushMargin = 1.05;

/// After the joint is pushed up with `push`, released, pushed down and released.
struct Reading {
    double q_low = 0.0, q_high = 0.0;
    bool inside = true, held = true;
    bool full = true;  ///< a stronger push would read the same
    [[nodiscard]] double width() const { return q_high - q_low; }
};

/// Pushes with torque `push` (signed), holds, releases.
/// @return true if a stronger push would read the same (docs/theory/stick_slip.md, "Full push")
bool push_and_release(StickSlip& path, double tau, double push, int steps) {
    const Joint& joint = path.joint();
    path.lead_to({tau, tau, push}, steps);
    path.lead_to({tau, tau, push}, 1);
    const Eigen::Vector3d coupling = stiffness(joint, path.z()).col(kOutput);
    path.lead_to({tau, tau, 0.0}, steps);
    for (const int i : {kAgonist, kAntagonist}) {
        const bool sticks = !joint.frozen[i] && joint.gear_friction[i].resting_loads(tau).width() > 0.0;
        if (sticks && path.sliding()[i] == 0.0 && coupling[i] != 0.0) return false;
    }
    const OutputFriction& bearing = joint.output_friction;
    return joint.frozen[kOutput] || (bearing.constant == 0.0 && bearing.tension_share == 0.0) || path.sliding()[kOutput] != 0.0;
}

/// What one co-contraction reads under any push.
class Readings {
public:
    Readings(const Joint& joint, double tau, int steps) : tau_(tau), steps_(steps), start_(joint) {
        start_.lead_to({tau, tau, 0.0}, steps);
    }
    /// The searches ask for some pushes again.
    const Reading& operator()(double push) {
        const auto [found, fresh] = known_.try_emplace(push);
        if (fresh) found->second = read(push);
        return found->second;
    }
    [[nodiscard]] const Joint& joint() const { return start_.joint(); }
    [[nodiscard]] double tau() const { return tau_; }

private:
    [[nodiscard]] Reading read(double push) const {
        StickSlip path = start_;
        Reading reading;
        reading.full = push_and_release(path, tau_, push, steps_);
        reading.q_high = path.z()[kOutput];
        reading.full = push_and_release(path, tau_, -push, steps_) && reading.full;
        reading.q_low = path.z()[kOutput];
        reading.inside = path.inside();
        reading.held = path.held();
        return reading;
    }

    double tau_;
    int steps_;
    StickSlip start_;
    std::map<double, Reading> known_;
};

/// Halves the bracket of a push: `enough(low)` is false, `enough(high)` true. @return its upper end
template <class Enough>
double least_push(double low, double high, const Enough& enough) {
    const double close = kPushDigits * high;
    while (high - low > close) {
        const double middle = 0.5 * (low + high);
        (enough(middle) ? high : low) = middle;
    }
    return high;
}

/// The strongest push in [low, high] of which `good` is true; `good(low)` is.
template <class Good>
double strongest_push(double low, double high, const Good& good) {
    if (good(high)) return high;
    const double beyond = least_push(low, high, [&](double push) { return !good(push); });
    return std::max(low, beyond - kPushDigits * high);
}

/// See ReleaseReading::full_push: doubles the push until it is full or the joint runs away, and halves the last step.
double find_full_push(Readings& read) {
    const auto held = [&](double push) { return read(push).held; };
    double before = 0.0, push = kFirstPush * read.joint().ratio() * read.tau();
    Reading reading = read(push);
    for (int i = 0; i < kMostDoublings && reading.held && !reading.full; ++i) {
        before = push;
        push *= 2.0;
        reading = read(push);
    }
    if (!reading.held) reading = read(push = strongest_push(before, push, held));
    if (!reading.held || !reading.full) return core::kNan;
    const double same = (1.0 - kSameReading) * reading.width();
    return least_push(0.0, push, [&](double weaker) { return read(weaker).width() >= same; });
}

/// The default push: slightly more than the full one if the gears hold it.
double strong_push(Readings& read, double full) {
    const auto held = [&](double push) { return read(push).held; };
    if (std::isnan(full)) return strongest_push(0.0, read.joint().ratio() * read.tau(), held);
    return strongest_push(full, kFullPushMargin * full, held);
}

}  // namespace

ReleaseReading release_test(const Joint& joint, double tau, const ReleaseTest& test) {
    constexpr double kLargest = std::numeric_limits<double>::max();
    core::require_positive("tau", tau, "Nm");
    core::require_within("push_torque", test.push_torque, 0.0, kLargest, "Nm");
    core::require_within("steps", test.steps, 1, kLargest);
    ReleaseReading result;
    result.tau = tau;
    Readings read(joint, tau, test.steps), search(joint, tau, kSearchSteps);
    const bool covered = read(0.0).inside;
    if (covered && (test.push_torque == 0.0 || test.find_full_push)) result.full_push = find_full_push(search);
    if (covered) result.push_torque = test.push_torque == 0.0 ? strong_push(search, result.full_push) : test.push_torque;
    const Reading reading = read(result.push_torque);
    if (covered && test.find_full_push)
        result.covered_push = strongest_push(0.0, result.push_torque, [&](double push) { return search(push).inside; });
    const bool pushed = result.push_torque > 0.0;
    result.q_low = pushed ? reading.q_low : core::kNan;
    result.q_high = pushed ? reading.q_high : core::kNan;
    result.inside = reading.inside;
    return result;
}

}  // namespace fusee::actuator
