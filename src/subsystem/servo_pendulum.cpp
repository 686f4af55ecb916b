#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/gap_case/likely_unit.h"
#include "law.h"
#include "servo_rollout.h"

namespace fusee::subsystem {

namespace {

constexpr double kLeastSigma = 1e-3;          // [rad]; what a rollout's own steps leave open
constexpr double kLongestDelay = 0.1;         // [s]
constexpr std::size_t kStepsOfAll = 100'000;  // of all rollouts of a diagnosis together: half a minute of two cores

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

ServoPendulum::ServoPendulum(const Case& subsystem_case, bool for_inputs) {
    measured_name = "q_rad";
    region_name = "t_s";
    unit = "rad";
    most_effects = 4;
    whole_sets = 2;
    many_minima = true;
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

/// The sigma of the sensor as given, or else as the readings show it: their least difference, or their scatter from row to row.
void ServoPendulum::set_sigma(const Case& subsystem_case) {
    unit_sigma =
        std::max(number_or(subsystem_case.sensors, "encoder_noise_rad", 0.0), number_or(subsystem_case.sensors, "encoder_step_rad", 0.0));
    if (unit_sigma > 0.0) return;
    for (const Record& record : subsystem_case.records) {
        const std::vector<double>& q = record.columns.at("q_rad");
        unit_sigma = std::max({unit_sigma, gap_case::step_of(q), scatter_of(q)});
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
    const auto given = [&](const char* name, double otherwise) { return number_or(subsystem_case.parameters, name, otherwise); };
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
    const double weight = largest(&Rollout::gravity);
    parameters[ServoParameter::kLoadQuadratic] = {"load_quadratic", "1/Nm", 0.0, 0.0, 5.0 / weight, {0.2 / weight}};
    parameters[ServoParameter::kStribeck] = {"stribeck", "", 0.0, 0.0, 5.0, {0.5}};
    parameters[ServoParameter::kStribeckSpeed] = {"stribeck_speed", "rad/s", 0.5, 0.02, 5.0, {0.5}};
    parameters[ServoParameter::kAsymmetry] = {"asymmetry", "", 0.0, -0.9, 0.9, {0.05}};
    parameters[ServoParameter::kGain] = {"gain", "", 0.0, -0.6, 2.0, {0.05}};
    parameters[ServoParameter::kDelay] = {"delay", "s", 0.0, 0.0, kLongestDelay, {0.01, 0.03}};
    effects = {{{"gear.load_friction"}, {ServoParameter::kLoadFriction}, false, ""},
               {{"gear.load_quadratic"}, {ServoParameter::kLoadQuadratic}, false, ""},
               {{"gear.stribeck"}, {ServoParameter::kStribeck, ServoParameter::kStribeckSpeed}, false, ""},
               {{"gear.asymmetry"}, {ServoParameter::kAsymmetry}, false, ""},
               {{"loop.gain"}, {ServoParameter::kGain}, false, "", "duty_per_kp_rad, kp and vin_V"},
               {{"loop.delay"}, {ServoParameter::kDelay}, false, "", "the times of the goals against those of q_rad"}};
    if (nominal > ServoParameter::kLoop) effects[4].unseen = "duty_per_kp_rad is not given and is fitted";
}

void ServoPendulum::predict(std::size_t record, const Values& values, std::vector<double>& predicted) const {
    simulate(rollouts_[record], values, predicted);
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
