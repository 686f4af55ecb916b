#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "law.h"

namespace fusee::subsystem {

namespace {

struct ServoParameter {
    enum : std::size_t {
        kTorqueConstant,
        kResistance,
        kArmature,
        kCoulomb,
        kViscous,
        kOffset,
        kLoop,
        kLoadFriction,
        kStribeck,
        kStribeckSpeed,
        kAsymmetry,
        kGain,
        kDelay,
        kGoals,
        kPlaces
    };
};

constexpr double kGravity = 9.81;                    // [m/s^2]
constexpr double kLongestStep = 4e-3;                // [s]; halving it moves a rollout by less than an encoder step
constexpr double kLeastSigma = 1e-3;                 // [rad]; what a rollout's own steps leave open
constexpr double kLongestDelay = 0.1;                // [s]
constexpr std::size_t kStepsOfAll = 100'000;         // of all rollouts of a diagnosis together: half a minute of two cores
constexpr std::size_t kStepsToAsk = 4096;            // a millisecond
constexpr std::size_t kMostPredicted = 100'000'000;  // of a prediction: some seconds

/// How goals run between two rows, as the value of the parameter `goals`.
struct Goals {
    static constexpr double kStraight = 0.0, kHeld = 1.0, kJumps = 2.0;  // the last: straight, but a jump comes with its row
};

/// Servos whose position loop is known: the duty for each kp and rad of error [1/rad].
struct KnownServo {
    const char* word;  // of motor=...
    const char* name;
    double duty_per_kp_rad;
};
constexpr KnownServo kXl330{"xl330", "DYNAMIXEL XL330", 4096.0 / (2.0 * core::kPi) / (256.0 * 885.0)};

struct Rollout {
    std::vector<double> time, goal;
    std::vector<bool> powered;
    double start = 0.0;
    double gravity = 0.0, load_inertia = 0.0;  // m g l [Nm], m l^2 [kg m^2]
    double kp = 0.0, supply = 0.0;             // [V]
    std::optional<double> duty;                // for each kp and rad of error; none: fitted
    std::vector<bool> jumps;                   // the goal of the row is far from that of the row before
    std::optional<double> goals;               // Goals; none: as the values say
};

class ServoPendulum final : public Law {
public:
    ServoPendulum(const Case& subsystem_case, bool for_inputs);
    void predict(std::size_t record, const Values& values, std::vector<double>& predicted) const override;
    [[nodiscard]] diagnosis::NextExperiment next() const override;
    [[nodiscard]] std::vector<std::string> remarks() const override {
        if (several_masses_) return {};
        return {
            "with one mass on the arm, kt, R and friction are partly confounded: the duty gives torque only in proportion to kt/R, and "
            "back-EMF "
            "and viscous friction have the same effect wherever the torque is on; loop.gain cannot be distinguished from kt and R at all "
            "unless the duty "
            "saturates"};
    }

private:
    void set_parameters(const Case& subsystem_case);
    void set_effects();
    void set_open_goals();
    void set_sigma(const Case& subsystem_case);
    void cut_long_logs();
    [[nodiscard]] double duty_at_start(const Case& subsystem_case, double drive) const;
    [[nodiscard]] double largest(double Rollout::*figure) const;

    std::vector<Rollout> rollouts_;
    bool several_masses_ = false;
};

/// Of the file, or of a servo that its word names.
std::optional<double> duty_of(const Record& record) {
    if (const auto given = record.parameters.find("duty_per_kp_rad"); given != record.parameters.end()) return given->second;
    const auto motor = record.words.find("motor");
    if (motor == record.words.end()) return std::nullopt;
    std::string word = motor->second;
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return word.find(kXl330.word) != std::string::npos ? std::optional(kXl330.duty_per_kp_rad) : std::nullopt;
}

std::size_t steps_between(double from, double to) { return static_cast<std::size_t>(std::max(1.0, std::ceil((to - from) / kLongestStep))); }

std::size_t steps_of(const Rollout& roll, std::size_t most) {
    std::size_t steps = 0;
    for (std::size_t i = 1; i < roll.time.size() && steps <= most; ++i) steps += steps_between(roll.time[i - 1], roll.time[i]);
    return steps;
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

ServoPendulum::ServoPendulum(const Case& subsystem_case, bool for_inputs) {
    measured_name = "q_rad";
    region_name = "t_s";
    unit = "rad";
    most_effects = 2;
    for (const Record& record : subsystem_case.records) rollouts_.push_back(rollout_of(record));
    if (!for_inputs) cut_long_logs();
    set_parameters(subsystem_case);
    set_effects();
    for (const Rollout& roll : rollouts_) several_masses_ |= roll.gravity < 0.95 * largest(&Rollout::gravity);
    if (for_inputs) return;
    set_sigma(subsystem_case);
    for (std::size_t r = 0; r < rollouts_.size(); ++r) {
        Target target;
        target.measured = subsystem_case.records[r].columns.at("q_rad");
        target.measured.resize(rollouts_[r].time.size());
        target.sigma.assign(target.measured.size(), unit_sigma);
        target.region = rollouts_[r].time;
        target.group = fmt::format("pendulum_log, kp {:g}", subsystem_case.records[r].parameters.at("kp"));
        targets.push_back(std::move(target));
    }
    make_blocks(*this, subsystem_case);
    std::vector<std::string> gains, trajectories;
    for (const Record& record : subsystem_case.records) {
        gains.push_back(fmt::format("{:g}", record.parameters.at("kp")));
        const auto word = record.words.find("trajectory");
        trajectories.push_back(word != record.words.end() ? word->second : "unnamed");
    }
    add_scheme(*this, "kp", gains);
    add_scheme(*this, "trajectory", trajectories);
    floor_remarks.push_back(
        fmt::format("no two files have the same motion: the floor is that of the encoder, {:.3g} rad, not that of a set-up", unit_sigma));
}

double ServoPendulum::largest(double Rollout::*figure) const {
    double most = 0.0;
    for (const Rollout& roll : rollouts_) most = std::max(most, roll.*figure);
    return most;
}

/// A diagnosis integrates each log some thousand times.
void ServoPendulum::cut_long_logs() {
    const std::size_t most = kStepsOfAll / rollouts_.size();
    for (Rollout& roll : rollouts_) {
        std::size_t rows = 1, steps = 0;
        for (; rows < roll.time.size(); ++rows)
            if ((steps += steps_between(roll.time[rows - 1], roll.time[rows])) > most) break;
        if (rows == roll.time.size()) continue;
        floor_remarks.push_back(fmt::format("of a log of {:.4g} s the first {:.4g} s are used: {} steps for all files",
                                            roll.time.back() - roll.time.front(), roll.time[rows - 1] - roll.time.front(), kStepsOfAll));
        roll.time.resize(rows);
    }
}

/// Of the sensor as given, or else as the readings show it: their least difference, or their scatter from row to row.
void ServoPendulum::set_sigma(const Case& subsystem_case) {
    const auto sensor = [&](const char* name) {
        const auto at = subsystem_case.sensors.find(name);
        return at != subsystem_case.sensors.end() ? at->second : 0.0;
    };
    unit_sigma = std::max(sensor("encoder_noise_rad"), sensor("encoder_step_rad"));
    if (unit_sigma > 0.0) return;
    for (const Record& record : subsystem_case.records) {
        const std::vector<double>& q = record.columns.at("q_rad");
        unit_sigma = std::max({unit_sigma, step_of(q), scatter_of(q)});
    }
    unit_sigma = std::max(unit_sigma, kLeastSigma);
    floor_remarks.push_back(fmt::format("sigma is {:.3g} rad, as the readings show: no sensors.encoder_step_rad is given", unit_sigma));
}

/// What balances the weight where the arm hardly moves, for a motor of `drive` Nm/V; a known servo's where no row tells.
double ServoPendulum::duty_at_start(const Case& subsystem_case, double drive) const {
    double pulls = 0.0, squares = 0.0;
    for (std::size_t r = 0; r < rollouts_.size(); ++r) {
        const Rollout& roll = rollouts_[r];
        const auto q = subsystem_case.records[r].columns.find("q_rad");
        if (q == subsystem_case.records[r].columns.end()) continue;
        for (std::size_t i = 0; i < roll.time.size(); ++i) {
            if (!roll.powered[i]) continue;
            const double volts = roll.kp * roll.supply * (roll.goal[i] - q->second[i]);
            pulls += volts * roll.gravity * std::sin(q->second[i]);
            squares += volts * volts;
        }
    }
    return pulls > 0.0 ? pulls / squares / drive : kXl330.duty_per_kp_rad;
}

/// Starts and ranges hold for all files together: no order of theirs changes them.
void ServoPendulum::set_parameters(const Case& subsystem_case) {
    const auto given = [&](const char* name, double fallback) {
        const auto at = subsystem_case.parameters.find(name);
        return at != subsystem_case.parameters.end() ? at->second : fallback;
    };
    const double weight = largest(&Rollout::gravity), load = largest(&Rollout::load_inertia);
    const double stall = 1.5 * weight;  // a guess: a servo that lifts its mass with some reserve
    const double kt = given("kt_Nm_per_A", stall), resistance = given("resistance_ohm", largest(&Rollout::supply) * kt / stall);
    const double armature = given("armature_kgm2", 0.3 * load), coulomb = given("coulomb_Nm", 0.05 * weight),
                 viscous = given("viscous_Nms", 0.02 * weight);
    const double most_inertia = 5.0 * std::max(load, armature), most_friction = std::max(weight, coulomb),
                 most_viscous = 2.0 * std::max(weight, viscous);
    constexpr double kFar = 20.0;  // times the usual range: an end that no servo reaches
    parameters.resize(ServoParameter::kPlaces);
    const auto from_zero = [&](const char* name, const char* units, double start, double usual) {
        return Parameter{name, units, start, 0.0, kFar * usual, {}, 0.0, OwnEnds::kLow, usual};
    };
    parameters[ServoParameter::kTorqueConstant] = {"kt", "Nm/A", kt, 0.005 * kt, 200.0 * kt, {}, 0.0, OwnEnds::kNone, 20.0 * kt};
    parameters[ServoParameter::kResistance] = {"resistance", "ohm", resistance,     0.005 * resistance, 200.0 * resistance,
                                               {},           0.0,   OwnEnds::kNone, 20.0 * resistance};
    parameters[ServoParameter::kArmature] = from_zero("armature", "kg m^2", armature, most_inertia);
    parameters[ServoParameter::kCoulomb] = from_zero("coulomb", "Nm", coulomb, most_friction);
    parameters[ServoParameter::kViscous] = from_zero("viscous", "Nms", viscous, most_viscous);
    parameters[ServoParameter::kOffset] = {"offset", "rad", given("offset_rad", 0.0), -0.5, 0.5, {}};
    nominal = ServoParameter::kOffset + 1;
    const double duty = duty_at_start(subsystem_case, kt / resistance);
    parameters[ServoParameter::kLoop] = {"duty_per_kp_rad", "1/rad", duty, 0.005 * duty, 200.0 * duty, {}, 0.0, OwnEnds::kNone, 5.0 * duty};
    parameters[ServoParameter::kGoals] = {"goals", "", Goals::kStraight, Goals::kStraight, Goals::kJumps, {}, 0.0, OwnEnds::kBoth};
    const auto of_all = [&](auto Rollout::*figure) {
        return std::all_of(rollouts_.begin(), rollouts_.end(), [figure](const Rollout& roll) { return (roll.*figure).has_value(); });
    };
    const auto unless_given = [&](const char* name, double start, std::vector<double> factors) {
        if (subsystem_case.parameters.contains(name)) return std::vector<double>{};
        for (double& factor : factors) factor *= start;
        return factors;
    };
    parameters[ServoParameter::kArmature].starts = unless_given("armature_kgm2", armature, {1.0, 10.0});
    parameters[ServoParameter::kResistance].starts = unless_given("resistance_ohm", resistance, {1.0, 0.3});
    if (!of_all(&Rollout::goals)) set_open_goals();
    if (of_all(&Rollout::duty)) return;
    nominal = ServoParameter::kLoop + 1;
    parameters[ServoParameter::kLoop].starts = {duty, 0.3 * duty};
    defaults.push_back(
        fmt::format("bench.duty_per_kp_rad is not given, and no motor = \"{}\" ({}, {:.4g} 1/rad) in its place: the gain of the position "
                    "loop is fitted, "
                    "so that a loop.gain cannot be seen and kt, R and friction follow the fitted gain",
                    kXl330.word, kXl330.name, kXl330.duty_per_kp_rad));
}

/// Where all steps of the goals are jumps, or none is, two choices are the same.
void ServoPendulum::set_open_goals() {
    std::size_t steps = 0, jumps = 0;
    for (const Rollout& roll : rollouts_)
        for (std::size_t i = 1; i < roll.time.size(); ++i) {
            if (roll.goals || roll.goal[i] == roll.goal[i - 1]) continue;
            ++steps;
            if (roll.jumps[i]) ++jumps;
        }
    open_input = {ServoParameter::kGoals,
                  {{Goals::kStraight, "\"straight\" between rows"}, {Goals::kHeld, "\"held\" until the next row"}},
                  "bench.goals"};
    if (jumps > 0 && jumps < steps) open_input->choices.emplace_back(Goals::kJumps, "\"jumps\": straight, a jump with its row");
}

void ServoPendulum::set_effects() {
    parameters[ServoParameter::kLoadFriction] = {"load_friction", "", 0.0, 0.0, 0.9, {0.1}};
    parameters[ServoParameter::kStribeck] = {"stribeck", "", 0.0, 0.0, 5.0, {0.5}};
    parameters[ServoParameter::kStribeckSpeed] = {"stribeck_speed", "rad/s", 0.5, 0.02, 5.0, {0.5}};
    parameters[ServoParameter::kAsymmetry] = {"asymmetry", "", 0.0, -0.9, 0.9, {0.05}};
    parameters[ServoParameter::kGain] = {"gain", "", 0.0, -0.6, 2.0, {0.05}};
    parameters[ServoParameter::kDelay] = {"delay", "s", 0.0, 0.0, kLongestDelay, {0.01, 0.03}};
    effects = {{{"gear.load_friction"}, {ServoParameter::kLoadFriction}, false, ""},
               {{"gear.stribeck"}, {ServoParameter::kStribeck, ServoParameter::kStribeckSpeed}, false, ""},
               {{"gear.asymmetry"}, {ServoParameter::kAsymmetry}, false, ""},
               {{"loop.gain"}, {ServoParameter::kGain}, false, "", "duty_per_kp_rad, kp and vin_V"},
               {{"loop.delay"}, {ServoParameter::kDelay}, false, "", "the times of the goals against those of q_rad"}};
    if (nominal > ServoParameter::kLoop) effects[3].unseen = "duty_per_kp_rad is not given and is fitted";
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

    /// Of all steps until the next call.
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
        // What presses the teeth: half of what pulls on the gear from both sides.
        double friction = v_[ServoParameter::kCoulomb] + v_[ServoParameter::kLoadFriction] * 0.5 * std::abs(motor - load);
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

void ServoPendulum::predict(std::size_t record, const Values& values, std::vector<double>& predicted) const {
    const Rollout& roll = rollouts_[record];
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

diagnosis::NextExperiment ServoPendulum::next() const {
    diagnosis::NextExperiment next;
    next.experiment = "pendulum_log";
    next.variable = "mass_kg";
    double mass = 0.0;
    for (const Rollout& roll : rollouts_) mass = std::max(mass, roll.gravity * roll.gravity / (kGravity * kGravity * roll.load_inertia));
    next.set_points = {0.0, mass, 2.0 * mass};
    next.cost = 15.0;
    next.text = fmt::format(
        "the same trajectories with {:.2g} kg and with the bare arm, each twice: friction that grows with the load is then distinguished "
        "from kt, R and constant friction, and the repeats give the floor of a set-up; a locked arm at three duties gives kt/R alone",
        2.0 * mass);
    return next;
}

}  // namespace

std::unique_ptr<Law> servo_pendulum(const Case& subsystem_case, bool for_inputs) {
    return std::make_unique<ServoPendulum>(subsystem_case, for_inputs);
}

}  // namespace fusee::subsystem
