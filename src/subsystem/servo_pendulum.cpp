#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
        kLoadFriction,
        kStribeck,
        kStribeckSpeed,
        kAsymmetry,
        kGain,
        kDelay,
        kPlaces
    };
};

constexpr double kGravity = 9.81;      // [m/s^2]
constexpr double kLongestStep = 4e-3;  // [s]; halving it moves a rollout by less than an encoder step
constexpr double kDutyPerKpRad = 4096.0 / (2.0 * core::kPi) / (256.0 * 885.0);  // position loop of the DYNAMIXEL X series
constexpr double kEncoderStep = 2.0 * core::kPi / 4096.0;                       // [rad]
constexpr double kLongestDelay = 0.1;                                           // [s]

struct Rollout {
    std::vector<double> time, goal;
    std::vector<bool> powered;
    double start = 0.0, start_speed = 0.0;
    double gravity = 0.0, load_inertia = 0.0;  // m g l [Nm], m l^2 [kg m^2]
    double loop = 0.0, supply = 0.0;           // duty per rad of error; [V]
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

    std::vector<Rollout> rollouts_;
    bool several_masses_ = false;
};

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
    const auto given = record.parameters.find("duty_per_kp_rad");
    roll.loop = number_of(record, {"kp"}) * (given != record.parameters.end() ? given->second : kDutyPerKpRad);
    roll.supply = number_of(record, {"vin_V", "supply_V", "supply"});
    return roll;
}

ServoPendulum::ServoPendulum(const Case& subsystem_case, bool for_inputs) {
    measured_name = "q_rad";
    region_name = "t_s";
    unit = "rad";
    most_effects = 2;
    for (const Record& record : subsystem_case.records) rollouts_.push_back(rollout_of(record));
    set_parameters(subsystem_case);
    for (const Rollout& roll : rollouts_) several_masses_ |= std::abs(roll.gravity - rollouts_.front().gravity) > 0.05 * roll.gravity;
    if (for_inputs) return;
    const auto sensor = [&](const char* name, double fallback) {
        const auto at = subsystem_case.sensors.find(name);
        return at != subsystem_case.sensors.end() ? at->second : fallback;
    };
    unit_sigma = std::max(sensor("encoder_noise_rad", 0.0), sensor("encoder_step_rad", kEncoderStep));
    for (std::size_t r = 0; r < rollouts_.size(); ++r) {
        Target target;
        target.measured = subsystem_case.records[r].columns.at("q_rad");
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

void ServoPendulum::set_parameters(const Case& subsystem_case) {
    const auto given = [&](const char* name, double fallback) {
        const auto at = subsystem_case.parameters.find(name);
        return at != subsystem_case.parameters.end() ? at->second : fallback;
    };
    const Rollout& first = rollouts_.front();
    const double weight = first.gravity, stall = 1.5 * weight;  // a guess: a servo that lifts its mass with some reserve
    const double kt = given("kt_Nm_per_A", stall), resistance = given("resistance_ohm", first.supply * kt / stall);
    parameters.resize(ServoParameter::kPlaces);
    parameters[ServoParameter::kTorqueConstant] = {"kt", "Nm/A", kt, 0.05 * kt, 20.0 * kt, {}};
    parameters[ServoParameter::kResistance] = {"resistance", "ohm", resistance, 0.05 * resistance, 20.0 * resistance, {}};
    parameters[ServoParameter::kArmature] = {
        "armature", "kg m^2", given("armature_kgm2", 0.3 * first.load_inertia), 0.0, 5.0 * first.load_inertia, {}};
    parameters[ServoParameter::kCoulomb] = {"coulomb", "Nm", given("coulomb_Nm", 0.05 * weight), 0.0, weight, {}};
    parameters[ServoParameter::kViscous] = {"viscous", "Nms", given("viscous_Nms", 0.02 * weight), 0.0, 2.0 * weight, {}};
    parameters[ServoParameter::kOffset] = {"offset", "rad", given("offset_rad", 0.0), -0.5, 0.5, {}};
    parameters[ServoParameter::kLoadFriction] = {"load_friction", "", 0.0, 0.0, 0.9, {0.1}};
    parameters[ServoParameter::kStribeck] = {"stribeck", "", 0.0, 0.0, 5.0, {0.5}};
    parameters[ServoParameter::kStribeckSpeed] = {"stribeck_speed", "rad/s", 0.5, 0.02, 5.0, {0.5}};
    parameters[ServoParameter::kAsymmetry] = {"asymmetry", "", 0.0, -0.9, 0.9, {0.05}};
    parameters[ServoParameter::kGain] = {"gain", "", 0.0, -0.6, 2.0, {0.05}};
    parameters[ServoParameter::kDelay] = {"delay", "s", 0.0, 0.0, kLongestDelay, {0.01}};
    nominal = ServoParameter::kOffset + 1;
    effects = {{{"gear.load_friction"}, {ServoParameter::kLoadFriction}, false, ""},
               {{"gear.stribeck"}, {ServoParameter::kStribeck, ServoParameter::kStribeckSpeed}, false, ""},
               {{"gear.asymmetry"}, {ServoParameter::kAsymmetry}, false, ""},
               {{"loop.gain"}, {ServoParameter::kGain}, false, ""},
               {{"loop.delay"}, {ServoParameter::kDelay}, false, ""}};
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

/// The pendulum in time (docs/subsystem-cases.md, eq. 4 to 6): implicit in speed, friction as the impulse that stops or else opposes
/// (J. J. Moreau's time stepping), so that sticking is exact.
class Pendulum {
public:
    Pendulum(const Rollout& roll, const Values& values)
        : roll_(roll),
          v_(values),
          drive_(values[ServoParameter::kTorqueConstant] / values[ServoParameter::kResistance]),
          inertia_(roll.load_inertia + values[ServoParameter::kArmature]),
          error_(values[ServoParameter::kDelay]),
          q_(roll.start) {}

    [[nodiscard]] double q() const { return q_; }

    void step(double time, double h, double goal, bool powered) {
        const double error = error_(time, goal - q_);
        const double duty = std::clamp((1.0 + v_[ServoParameter::kGain]) * roll_.loop * error, -1.0, 1.0);
        const double push = powered ? drive_ * duty * roll_.supply : 0.0;
        const double damping = v_[ServoParameter::kViscous] + (powered ? drive_ * v_[ServoParameter::kTorqueConstant] : 0.0);
        const double load = -roll_.gravity * std::sin(q_ + v_[ServoParameter::kOffset]);
        const double mass = inertia_ + h * damping;
        const double free = (inertia_ * speed_ + h * (push + load)) / mass;  // without friction
        const double motor = push - (powered ? drive_ * v_[ServoParameter::kTorqueConstant] * speed_ : 0.0);
        // What presses the teeth: half of what pulls on the gear from both sides.
        double friction = v_[ServoParameter::kCoulomb] + v_[ServoParameter::kLoadFriction] * 0.5 * std::abs(motor - load);
        friction *= 1.0 + std::copysign(v_[ServoParameter::kAsymmetry], free);
        if (v_[ServoParameter::kStribeck] > 0.0)
            friction *= 1.0 + v_[ServoParameter::kStribeck] * std::exp(-std::pow(speed_ / v_[ServoParameter::kStribeckSpeed], 2));
        const double loss = h * friction / mass;
        speed_ = std::abs(free) <= loss ? 0.0 : free - std::copysign(loss, free);
        q_ += h * speed_;
    }

private:
    const Rollout& roll_;
    const Values& v_;
    double drive_, inertia_;  // [Nm/V], [kg m^2]
    Delayed error_;
    double q_, speed_ = 0.0;
};

void ServoPendulum::predict(std::size_t record, const Values& values, std::vector<double>& predicted) const {
    const Rollout& roll = rollouts_[record];
    Pendulum pendulum(roll, values);
    predicted.resize(roll.time.size());
    predicted[0] = pendulum.q();
    for (std::size_t i = 1; i < roll.time.size(); ++i) {
        const double span = roll.time[i] - roll.time[i - 1];
        const int steps = std::clamp(static_cast<int>(std::ceil(span / kLongestStep)), 1, 1000);
        const double h = span / steps;
        for (int s = 0; s < steps; ++s) {
            const double share = (s + 0.5) / steps;
            pendulum.step(roll.time[i - 1] + h * s, h, roll.goal[i - 1] + share * (roll.goal[i] - roll.goal[i - 1]), roll.powered[i - 1]);
        }
        predicted[i] = pendulum.q();
    }
}

diagnosis::NextExperiment ServoPendulum::next() const {
    diagnosis::NextExperiment next;
    next.experiment = "pendulum_log";
    next.variable = "mass_kg";
    const Rollout& first = rollouts_.front();
    const double mass = first.gravity * first.gravity / (kGravity * kGravity * first.load_inertia);
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
