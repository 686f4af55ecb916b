#include "servo_rollout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "fusee/core/error.h"
#include "fusee/core/text.h"

namespace fusee::subsystem {

namespace {

constexpr double kLongestStep = 4e-3;                // [s]; halving it moves a rollout by less than an encoder step
constexpr std::size_t kStepsToAsk = 4096;            // a millisecond
constexpr std::size_t kMostPredicted = 100'000'000;  // of a prediction: some seconds

/// The duty of the file, or of a servo that its word names.
std::optional<double> duty_of(const Record& record) {
    if (const auto given = record.parameters.find("duty_per_kp_rad"); given != record.parameters.end()) return given->second;
    const auto motor = record.words.find("motor");
    if (motor == record.words.end()) return std::nullopt;
    const std::string word = core::lower(motor->second);
    return word.find(kXl330.word) != std::string::npos ? std::optional(kXl330.duty_per_kp_rad) : std::nullopt;
}

/// Steps between goals that are far greater than those before and after.
std::vector<bool> jumps_of(const std::vector<double>& goal) {
    constexpr double kLeast = 0.01, kFarGreater = 5.0;  // [rad]
    const auto step = [&](std::size_t i) { return i > 0 && i < goal.size() ? std::abs(goal[i] - goal[i - 1]) : 0.0; };
    std::vector<bool> jumps;
    for (std::size_t i = 0; i < goal.size(); ++i)
        jumps.push_back(step(i) > kLeast && step(i) > kFarGreater * std::max(step(i - std::min<std::size_t>(i, 1)), step(i + 1)));
    return jumps;
}

/// What the loop saw `delay` ago: the errors of the past steps, straight between them.
class Delayed {
public:
    explicit Delayed(double delay) : delay_(delay) {}
    double operator()(double time, double error) {
        if (delay_ <= 0.0) return error;
        times_.push_back(time);
        errors_.push_back(error);
        const double then = time - delay_;
        if (then <= times_.front()) return errors_.front();
        while (times_[at_ + 1] < then) ++at_;
        const double share = (then - times_[at_]) / (times_[at_ + 1] - times_[at_]);
        return errors_[at_] + share * (errors_[at_ + 1] - errors_[at_]);
    }

private:
    double delay_;
    std::vector<double> times_, errors_;
    std::size_t at_ = 0;
};

/// The pendulum in time (docs/subsystem-cases.md, eq. 4 to 6): half a step of motion, the torques there, half a step of motion (leapfrog).
/// Damping within a step is exact; friction is the impulse that stops or else opposes (J. J. Moreau's time stepping), so that sticking is.
class Pendulum {
public:
    Pendulum(const Rollout& roll, const Values& values)
        : roll_(roll),
          v_(values),
          drive_(values[ServoParameter::kTorqueConstant] / values[ServoParameter::kResistance]),
          back_emf_(drive_ * values[ServoParameter::kTorqueConstant]),
          inertia_(roll.load_inertia + values[ServoParameter::kArmature]),
          loop_((1.0 + values[ServoParameter::kGain]) * roll.kp * roll.duty.value_or(values[ServoParameter::kLoop])),
          error_(values[ServoParameter::kDelay]),
          q_(roll.start) {}

    [[nodiscard]] double q() const { return q_; }

    /// Sets what all steps until the next call have.
    void set_step(double h, bool powered) {
        h_ = h;
        powered_ = powered;
        const double damping = v_[ServoParameter::kViscous] + (powered ? back_emf_ : 0.0);
        kept_ = std::exp(-h * damping / inertia_);
        impulse_ = damping > 0.0 ? -std::expm1(-h * damping / inertia_) / damping : h / inertia_;
    }

    /// @param middle time in the middle of the step, with the goal there
    void step(double middle, double goal) {
        q_ += 0.5 * h_ * speed_;
        const double error = error_(middle, goal - q_);
        const double push = powered_ ? drive_ * std::clamp(loop_ * error, -1.0, 1.0) * roll_.supply : 0.0;
        const double load = -roll_.gravity * std::sin(q_ + v_[ServoParameter::kOffset]);
        const double free = kept_ * speed_ + impulse_ * (push + load);  // without friction
        const double motor = push - (powered_ ? back_emf_ * speed_ : 0.0);
        const double teeth = 0.5 * std::abs(motor - load);  // what presses them: half of what pulls on the gear from both sides
        double friction =
            v_[ServoParameter::kCoulomb] + (v_[ServoParameter::kLoadFriction] + v_[ServoParameter::kLoadQuadratic] * teeth) * teeth;
        friction *= 1.0 + std::copysign(v_[ServoParameter::kAsymmetry], free);
        if (v_[ServoParameter::kStribeck] > 0.0)
            friction *= 1.0 + v_[ServoParameter::kStribeck] * std::exp(-std::pow(speed_ / v_[ServoParameter::kStribeckSpeed], 2));
        const double loss = impulse_ * friction;
        speed_ = std::abs(free) <= loss ? 0.0 : free - std::copysign(loss, free);
        q_ += 0.5 * h_ * speed_;
    }

private:
    const Rollout& roll_;
    const Values& v_;
    double drive_, back_emf_, inertia_, loop_;     // [Nm/V], [Nms], [kg m^2], [1/rad]
    double h_ = 0.0, kept_ = 1.0, impulse_ = 0.0;  // [s]; share of the speed after a step; speed for each Nm [1/(kg m^2/s)]
    bool powered_ = false;
    Delayed error_;
    double q_, speed_ = 0.0;
};

}  // namespace

std::size_t steps_between(double from, double to) { return static_cast<std::size_t>(std::max(1.0, std::ceil((to - from) / kLongestStep))); }

std::size_t steps_of(const Rollout& roll, std::size_t most) {
    std::size_t steps = 0;
    for (std::size_t i = 1; i < roll.time.size() && steps <= most; ++i) steps += steps_between(roll.time[i - 1], roll.time[i]);
    return steps;
}

Rollout rollout_of(const Record& record) {
    Rollout roll;
    roll.time = record.columns.at("t_s");
    roll.goal = record.columns.at("q_goal_rad");
    if (const auto enable = record.columns.find("torque_enable"); enable != record.columns.end())
        for (const double on : enable->second) roll.powered.push_back(on > 0.5);
    else
        roll.powered.assign(roll.time.size(), true);
    roll.start = roll.goal.front();
    if (const auto q = record.columns.find("q_rad"); q != record.columns.end()) roll.start = q->second.front();
    const double mass = number_of(record, {"mass_kg"}), length = number_of(record, {"length_m"});
    roll.gravity = mass * kGravity * length;
    roll.load_inertia = mass * length * length;
    roll.kp = number_of(record, {"kp"});
    roll.duty = duty_of(record);
    roll.supply = number_of(record, {"vin_V", "supply_V", "supply"});
    roll.jumps = jumps_of(roll.goal);
    if (const auto goals = record.words.find("goals"); goals != record.words.end())
        roll.goals = goals->second == "held" ? Goals::kHeld : goals->second == "jumps" ? Goals::kJumps : Goals::kStraight;
    if (steps_of(roll, kMostPredicted) > kMostPredicted)
        throw core::InvalidInput(
            record.file + ": t_s", fmt::format("{:g} to {:g}", roll.time.front(), roll.time.back()),
            fmt::format("at most {:g} s, which are {} steps; are these milliseconds?", kMostPredicted * kLongestStep, kMostPredicted));
    return roll;
}

void simulate(const Rollout& roll, const Values& values, std::vector<double>& predicted) {
    Pendulum pendulum(roll, values);
    predicted.resize(roll.time.size());
    predicted[0] = pendulum.q();
    const double goals = roll.goals.value_or(values[ServoParameter::kGoals]);
    for (std::size_t i = 1; i < roll.time.size(); ++i) {
        const std::size_t steps = steps_between(roll.time[i - 1], roll.time[i]);
        const double h = (roll.time[i] - roll.time[i - 1]) / static_cast<double>(steps);
        const bool held = goals == Goals::kHeld || (goals == Goals::kJumps && roll.jumps[i]);
        const double rise = held ? 0.0 : roll.goal[i] - roll.goal[i - 1];
        pendulum.set_step(h, roll.powered[i - 1]);
        for (std::size_t s = 0; s < steps; ++s) {
            if (s % kStepsToAsk == 0) stop_if_asked();
            const double middle = static_cast<double>(s) + 0.5;
            pendulum.step(roll.time[i - 1] + h * middle, roll.goal[i - 1] + middle / static_cast<double>(steps) * rise);
        }
        predicted[i] = pendulum.q();
    }
}

}  // namespace fusee::subsystem
