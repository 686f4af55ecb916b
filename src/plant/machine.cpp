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

Machine::Side Machine::side_of(const Truth& truth, const BuiltSprings& springs, std::size_t i) {
    const SideTruth& built = truth.sides[i];
    return {Bristles(truth.presliding, truth.bristle, damping_for(truth.bristle, built.inertia)), Spring(springs.se[i], built.se),
            Spring(springs.pe[i], built.pe)};
}

Machine::Machine(const Truth& truth, const BuiltSprings& springs, double session)
    : truth_(truth),
      sides_{side_of(truth, springs, 0), side_of(truth, springs, 1)},
      bearing_(truth.presliding, kBearingBristle, damping_for(kBearingBristle, truth.joint.inertia)),
      session_(session) {
    warm_up();
}

void Machine::warm_up() {
    for (std::size_t i = 0; i < 2; ++i) {
        sides_[i].warm = warmth(truth_.sides[i], session_);
        sides_[i].se.warm_up(session_);
        sides_[i].pe.warm_up(session_);
    }
}

double Machine::cable(std::size_t i) {
    Side& side = sides_[i];
    const double turned = truth_.sides[i].ratio() * truth_.joint.wound(q_);
    const double pull = side.se.pull(side.theta + (i == 0 ? turned : -turned) - side.slipped - bent_, kStep);
    if (!side.jumped && pull > truth_.sides[i].jump_torque) {
        side.jumped = true;
        side.slipped += truth_.sides[i].jump;
    }
    side.slipped += kStep * std::max(0.0, pull - truth_.sides[i].slip_torque) / truth_.sides[i].slip_drag;
    return pull;
}

void Machine::turn_motor(std::size_t i, double series, const Command& command) {
    Side& side = sides_[i];
    const SideTruth& built = truth_.sides[i];
    const double load = series + side.pe.pull(side.theta, kStep);
    const double cogging = built.cogging == 0.0 ? 0.0 : built.cogging * std::sin(built.cogging_turns * side.theta + built.cogging_phase);
    const double motor = delivered(built, command.motor[i], session_) + built.crosstalk * command.motor[1 - i] + cogging;
    const double stop = stop_torque(-side.theta, -side.speed, kMotorStop, kMotorStopDamping);
    side.speed += kStep / built.inertia * (motor - load - side.gear.torque() - built.viscous * side.speed + stop);
    side.theta += kStep * side.speed;
    side.gear.step(side.speed, gear_friction(built, load, side.theta, std::abs(side.speed), side.warm), kStep);
}

void Machine::turn_joint(const std::array<double, 2>& series, const Command& command) {
    const JointTruth& joint = truth_.joint;
    const double arm = joint.pulley == 0.0 ? 1.0 : joint.arm_factor(q_);
    const double up = arm * truth_.sides[1].ratio() * series[1], down = arm * truth_.sides[0].ratio() * series[0];
    joint_torque_ = command.joint;
    double torque = command.joint + up - down - bearing_.torque() - (joint.viscous + command.hand) * joint_speed_;
    torque -= fluid_drag(joint.drag, joint_speed_);
    torque -= (joint.harness + joint.hardening * q_ * q_) * q_;
    if (joint.gravity != 0.0) torque -= joint.gravity * std::sin(q_);
    torque -= stop_torque(q_ - joint.stop, joint_speed_, kJointStop, kJointStopDamping);
    torque += stop_torque(-q_ - joint.stop, -joint_speed_, kJointStop, kJointStopDamping);
    joint_speed_ += kStep / joint.inertia * torque;
    q_ += kStep * joint_speed_;
    double friction = joint.coulomb + joint.tension_friction * (up + down);
    if (joint.rough != 0.0) {
        const double away = (q_ - joint.rough_at) / joint.rough_width;
        friction += joint.rough * std::exp(-away * away);
    }
    bearing_.step(joint_speed_, friction, kStep);
}

void Machine::step(const Command& command) {
    const std::array<double, 2> series{cable(0), cable(1)};
    turn_motor(0, series[0], command);
    turn_motor(1, series[1], command);
    turn_joint(series, command);
    bent_ += kStep / kMountTime * (truth_.joint.mount * (series[0] + series[1]) - bent_);
    session_ += kStep;
}

void Machine::run(double seconds, const std::function<Command(double)>& command) {
    const long steps = std::lround(seconds / kStep);
    for (long i = 1; i <= steps; ++i) step(command(static_cast<double>(i) * kStep));
    warm_up();
}

double Machine::energy() const {
    const auto stored = [](const TorqueTable& table, double deflection) {
        constexpr int kParts = 2000;
        double sum = 0.0;
        for (int i = 0; i < kParts; ++i) sum += table.at(deflection * (i + 0.5) / kParts);
        return std::max(0.0, deflection) * sum / kParts;
    };
    double energy = 0.5 * truth_.joint.inertia * joint_speed_ * joint_speed_ + bearing_.stored();
    for (std::size_t i = 0; i < 2; ++i) {
        const Side& side = sides_[i];
        const double turned = truth_.sides[i].ratio() * q_;
        energy += 0.5 * truth_.sides[i].inertia * side.speed * side.speed + side.gear.stored();
        energy += stored(side.pe.table(), side.theta) + stored(side.se.table(), side.theta + (i == 0 ? turned : -turned) - side.slipped);
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
