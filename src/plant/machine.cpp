#include "fusee/plant/machine.h"

#include "fusee/core/error.h"

namespace fusee::plant {

namespace {

constexpr double kMotorStop = 2000.0, kMotorStopDamping = 2.0;  // [Nm/rad], [Nms]: where a capstan is unwound
constexpr double kJointStop = 300.0, kJointStopDamping = 0.4;
constexpr double kBearingBristle = 300.0;  // [Nm/rad]
constexpr double kBristleDamping = 0.7;    // share of the critical one
constexpr double kMountTime = 0.005;       // [s] in which a mount follows the cables; stable for mounts of up to 50 times K_SE's compliance

/// Push back [Nm] of a stop that is `deep` inside, none if it is not; a stop does not pull.
double stop_torque(double deep, double speed, double stiffness, double damping) {
    return deep > 0.0 ? std::max(0.0, stiffness * deep + damping * speed) : 0.0;
}

double damping_for(double stiffness, double inertia) { return 2.0 * kBristleDamping * std::sqrt(stiffness * inertia); }

}  // namespace

BuiltSprings::BuiltSprings(const Nominal& nominal, const Truth& truth) {
    for (std::size_t i = 0; i < 2; ++i) {
        se[i] = build_series(nominal, truth.sides[i]);
        pe[i] = build_parallel(nominal, truth.sides[i]);
    }
}

Drive::Drive(const Truth& truth, const BuiltSprings& springs, double session)
    : truth_(truth),
      sides_{Side{Spring(springs.se[0], truth.sides[0].se), Spring(springs.pe[0], truth.sides[0].pe)},
             Side{Spring(springs.se[1], truth.sides[1].se), Spring(springs.pe[1], truth.sides[1].pe)}},
      session_(session) {
    warm_up();
}

void Drive::warm_up() {
    for (std::size_t i = 0; i < 2; ++i) {
        sides_[i].warm = warmth(truth_.sides[i], session_);
        sides_[i].se.warm_up(session_);
        sides_[i].pe.warm_up(session_);
    }
}

double Drive::series(std::size_t i, double theta, double q, double dt) {
    Side& side = sides_[i];
    const SideTruth& built = truth_.sides[i];
    const double turned = built.ratio() * truth_.joint.wound(q);
    const double pull = side.se.pull(theta + (i == 0 ? turned : -turned) - side.slipped - bent_, dt);
    if (!side.jumped && pull > built.jump_torque) {
        side.jumped = true;
        side.slipped += built.jump;
    }
    side.slipped += dt * std::max(0.0, pull - built.slip_torque) / built.slip_drag;
    return pull;
}

double Drive::motor(std::size_t i, const std::array<double, 2>& command, double theta) const {
    const SideTruth& built = truth_.sides[i];
    const double cogging = built.cogging == 0.0 ? 0.0 : built.cogging * std::sin(built.cogging_turns * theta + built.cogging_phase);
    return delivered(built, command[i], session_) + built.crosstalk * command[1 - i] + cogging;
}

double Drive::bearing_limit(double q, double pulls) const {
    const JointTruth& joint = truth_.joint;
    double friction = joint.coulomb + joint.tension_friction * pulls;
    if (joint.rough != 0.0) {
        const double away = (q - joint.rough_at) / joint.rough_width;
        friction += joint.rough * std::exp(-away * away);
    }
    return friction;
}

void Drive::end_step(const std::array<double, 2>& series, double dt) {
    bent_ += dt / kMountTime * (truth_.joint.mount * (series[0] + series[1]) - bent_);
    session_ += dt;
}

Truth without_hysteresis(Truth truth) {
    for (SideTruth& side : truth.sides) side.se.hysteresis = side.pe.hysteresis = 0.0;
    return truth;
}

Machine::Machine(const Truth& truth, const BuiltSprings& springs, double session)
    : drive_(truth, springs, session),
      sides_{Side{Bristles(truth.presliding, truth.bristle, damping_for(truth.bristle, truth.sides[0].inertia))},
             Side{Bristles(truth.presliding, truth.bristle, damping_for(truth.bristle, truth.sides[1].inertia))}},
      bearing_(truth.presliding, kBearingBristle, damping_for(kBearingBristle, truth.joint.inertia)) {}

void Machine::turn_motor(std::size_t i, double series, const Command& command) {
    Side& side = sides_[i];
    const SideTruth& built = drive_.truth().sides[i];
    const double load = series + drive_.parallel(i, side.theta, kStep);
    const double motor = drive_.motor(i, command.motor, side.theta);
    const double stop = stop_torque(-side.theta, -side.speed, kMotorStop, kMotorStopDamping);
    side.speed += kStep / built.inertia * (motor - load - side.gear.torque() - built.viscous * side.speed + stop);
    side.theta += kStep * side.speed;
    side.gear.step(side.speed, drive_.gear_limit(i, load, side.theta, std::abs(side.speed)), kStep);
}

void Machine::turn_joint(const std::array<double, 2>& series, const Command& command) {
    const Truth& truth = drive_.truth();
    const JointTruth& joint = truth.joint;
    const double arm = joint.pulley == 0.0 ? 1.0 : joint.arm_factor(q_);
    const double up = arm * truth.sides[1].ratio() * series[1], down = arm * truth.sides[0].ratio() * series[0];
    joint_torque_ = command.joint;
    double torque = command.joint + up - down - bearing_.torque() - (joint.viscous + command.hand) * joint_speed_;
    torque -= fluid_drag(joint.drag, joint_speed_);
    torque -= (joint.harness + joint.hardening * q_ * q_) * q_;
    if (joint.gravity != 0.0) torque -= joint.gravity * std::sin(q_);
    torque -= stop_torque(q_ - joint.stop, joint_speed_, kJointStop, kJointStopDamping);
    torque += stop_torque(-q_ - joint.stop, -joint_speed_, kJointStop, kJointStopDamping);
    joint_speed_ += kStep / joint.inertia * torque;
    q_ += kStep * joint_speed_;
    bearing_.step(joint_speed_, drive_.bearing_limit(q_, up + down), kStep);
}

void Machine::step(const Command& command) {
    const std::array<double, 2> series{drive_.series(0, sides_[0].theta, q_, kStep), drive_.series(1, sides_[1].theta, q_, kStep)};
    turn_motor(0, series[0], command);
    turn_motor(1, series[1], command);
    turn_joint(series, command);
    drive_.end_step(series, kStep);
}

void Machine::run(double seconds, const std::function<Command(double)>& command) {
    const long steps = std::lround(seconds / kStep);
    for (long i = 1; i <= steps; ++i) step(command(static_cast<double>(i) * kStep));
    drive_.warm_up();
}

double Machine::energy() const {
    const auto stored = [](const TorqueTable& table, double deflection) {
        constexpr int kParts = 2000;
        double sum = 0.0;
        for (int i = 0; i < kParts; ++i) sum += table.at(deflection * (i + 0.5) / kParts);
        return std::max(0.0, deflection) * sum / kParts;
    };
    const Truth& truth = drive_.truth();
    double energy = 0.5 * truth.joint.inertia * joint_speed_ * joint_speed_ + bearing_.stored();
    for (std::size_t i = 0; i < 2; ++i) {
        const Side& side = sides_[i];
        const double turned = truth.sides[i].ratio() * q_;
        energy += 0.5 * truth.sides[i].inertia * side.speed * side.speed + side.gear.stored();
        energy += stored(drive_.parallel_table(i), side.theta);
        energy += stored(drive_.series_table(i), side.theta + (i == 0 ? turned : -turned) - drive_.slipped(i));
    }
    return energy;
}

std::unique_ptr<Motion> Engine::start(const Truth& truth, const BuiltSprings& springs, double session) const {
    if (truth.joint.play > 0.0) throw core::InvalidInput("effect", "outside.joint_play", "an effect that the plant's own machine has");
    return std::make_unique<Machine>(truth, springs, session);
}

/// L - tau = friction at rest (backdrive) or tau - L = friction at rest (drive), linear in L.
double Engine::break_away(const SideTruth& side, double motor, bool backdrive, double theta, double scatter, double session) const {
    const double warm = warmth(side, session);
    const double constant = scatter * gear_friction(side, 0.0, theta, 0.0, warm);
    const double share = scatter * gear_friction(side, 1.0, theta, 0.0, warm) - constant;
    const double torque = delivered(side, motor, session);
    return backdrive ? (torque + constant) / (1.0 - share) : std::max(0.0, (torque - constant) / (1.0 + share));
}

}  // namespace fusee::plant
