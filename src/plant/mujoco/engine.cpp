#include "mujoco/engine.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "model.h"

namespace fusee::plant {

namespace {

constexpr double kLoadRate = 0.005;   // at which a bench raises or lowers the load [Nm/s]
constexpr double kTurns = 0.002;      // speed at which a capstan has started [rad/s]
constexpr double kQuickShare = 0.97;  // of the expected friction that the bench leaves behind at once
constexpr double kSettled = 0.05;     // [s] until the motor of a bench has its torque
constexpr double kMostWait = 60.0;    // [s]
constexpr double kLeastFriction = 1e-9;

class MujocoMotion final : public Motion {
public:
    MujocoMotion(const Truth& truth, const BuiltSprings& springs, const Softness& softness, double session)
        : truth_(truth), model_(rig_xml(truth, softness)), drive_(without_hysteresis(truth), springs, session) {}

    void run(double seconds, const std::function<Command(double)>& command) override {
        const long steps = std::lround(seconds / kMujocoStep);
        for (long i = 1; i <= steps; ++i) step(command(static_cast<double>(i) * seconds / static_cast<double>(steps)));
        drive_.warm_up();
    }
    [[nodiscard]] double theta(std::size_t side) const override { return model_.data().qpos[side]; }
    [[nodiscard]] double q() const override { return pulley() + (truth_.joint.play > 0.0 ? model_.data().qpos[kPlay] : 0.0); }
    [[nodiscard]] double joint_torque() const override { return joint_torque_; }
    [[nodiscard]] double session() const override { return drive_.session(); }

private:
    [[nodiscard]] double pulley() const { return model_.data().qpos[kPulley]; }
    void step(const Command& command);
    void apply_side(std::size_t i, const Command& command, double series);
    void apply_joint(const Command& command, const std::array<double, 2>& series);
    void read_rubbing();

    Truth truth_;
    Model model_;
    Drive drive_;
    std::array<double, 4> rubbing_{};  // friction along each spring's tendon in the last step [Nm]
    double joint_torque_ = 0.0;
};

void MujocoMotion::apply_side(std::size_t i, const Command& command, double series) {
    const SideTruth& side = truth_.sides[i];
    mjData& data = model_.data();
    const double parallel = drive_.parallel(i, theta(i), kMujocoStep);
    const double load = std::max(0.0, series + rubbing_[i]) + std::max(0.0, parallel + rubbing_[kParallel + i]);
    data.ctrl[kMotor + i] = drive_.motor(i, command.motor, theta(i));
    data.ctrl[kSpringForce + i] = series;
    data.ctrl[kSpringForce + kParallel + i] = parallel;
    model_->dof_frictionloss[i] = std::max(kLeastFriction, drive_.gear_limit(i, load, theta(i), std::abs(data.qvel[i])));
    model_->tendon_frictionloss[i] = std::max(kLeastFriction, side.se.hysteresis * series);
    model_->tendon_frictionloss[kParallel + i] = std::max(kLeastFriction, side.pe.hysteresis * parallel);
}

void MujocoMotion::apply_joint(const Command& command, const std::array<double, 2>& series) {
    const JointTruth& joint = truth_.joint;
    mjData& data = model_.data();
    const double speed = data.qvel[kPulley], arm = joint.arm_factor(pulley());
    double pulls = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
        const double ratio = arm * truth_.sides[i].ratio();
        pulls += ratio * std::max(0.0, series[i] + rubbing_[i]);
        model_->wrap_prm[2 * i + 1] = i == 0 ? ratio : -ratio;  // the tendon's second joint
    }
    data.ctrl[kLinkTorque] = command.joint - joint.hardening * std::pow(pulley(), 3) - fluid_drag(joint.drag, speed);
    model_->dof_frictionloss[kPulley] = std::max(kLeastFriction, drive_.bearing_limit(pulley(), pulls));
    model_->dof_damping[kPulley] = joint.viscous;
    model_->tendon_damping[kLinkTendon] = command.hand;
    joint_torque_ = command.joint;
}

/// What the solver gave as friction along each tendon; it counts as the spring's pull.
void MujocoMotion::read_rubbing() {
    const mjData& data = model_.data();
    rubbing_ = {};
    for (int k = 0; k < data.nefc; ++k)
        if (data.efc_type[k] == mjCNSTR_FRICTION_TENDON && data.efc_id[k] < static_cast<int>(kLinkTendon))
            rubbing_.at(static_cast<std::size_t>(data.efc_id[k])) = -data.efc_force[k];
}

void MujocoMotion::step(const Command& command) {
    const std::array<double, 2> series{drive_.series(0, theta(0), pulley(), kMujocoStep),
                                       drive_.series(1, theta(1), pulley(), kMujocoStep)};
    for (std::size_t i = 0; i < 2; ++i) apply_side(i, command, series[i]);
    apply_joint(command, series);
    model_.step();
    read_rubbing();
    drive_.end_step(series, kMujocoStep);
}

}  // namespace

Softness draw_softness(Random& random) {
    Softness soft;
    soft.give = 2e-4 * std::pow(10.0, random.uniform(0.0, 1.0));
    soft.grip_time = random.uniform(0.002, 0.005);
    soft.stop_time = random.uniform(0.004, 0.012);
    soft.motor_lag = random.uniform(0.001, 0.004);
    return soft;
}

std::unique_ptr<Motion> MujocoEngine::start(const Truth& truth, const BuiltSprings& springs, double session) const {
    return std::make_unique<MujocoMotion>(truth, springs, softness_, session);
}

double MujocoEngine::break_away(const SideTruth& side, double motor, bool backdrive, double theta, double scatter, double session) const {
    const double warm = warmth(side, session), torque = delivered(side, motor, session);
    const double expected = Engine::break_away(side, motor, backdrive, theta, scatter, session);
    Model bench(bench_xml(side, softness_));
    mjData& data = bench.data();
    data.qpos[0] = theta;
    data.ctrl[1] = torque;
    const double begin = torque + kQuickShare * (expected - torque);
    for (double load = begin; data.time < kMostWait;
         load = begin + (backdrive ? 1.0 : -1.0) * kLoadRate * std::max(0.0, data.time - kSettled)) {
        if (load <= 0.0) return 0.0;
        data.ctrl[0] = data.time < kSettled ? begin * (1.0 - std::exp(-data.time / softness_.motor_lag)) : load;
        const double speed = std::abs(data.qvel[0]);
        bench->dof_frictionloss[0] = std::max(kLeastFriction, scatter * gear_friction(side, load, data.qpos[0], speed, warm));
        bench.step();
        if (data.time > kSettled && std::abs(data.qvel[0]) > kTurns) return load;
    }
    throw core::InputError("MuJoCo's capstan does not break away");
}

}  // namespace fusee::plant
