#include "fusee/joint_model/motion.h"

#include <algorithm>
#include <cmath>

namespace fusee::joint_model {

namespace {

using Torques = Motion::Torques;

Torques between(const Torques& from, const Torques& to, double share) {
    return {from.agonist + share * (to.agonist - from.agonist), from.antagonist + share * (to.antagonist - from.antagonist),
            from.joint + share * (to.joint - from.joint)};
}

/// Steps of equal length on one rig. Constants and state are local variables: this is
/// the innermost loop of a diagnosis.
class Stepper {
public:
    Stepper(const BuiltRig& rig, double hand_damping, double h, double session) : rig_(rig), h_(h) {
        for (std::size_t i = 0; i < 2; ++i) {
            per_mass_[i] = 1.0 / (rig.sides[i].motor_inertia + h * rig.sides[i].gear.viscous);
            drifted_[i] = rig.sides[i].gear.terms.drifted(session);
        }
        free_mass_ = rig.joint_inertia + h * (rig.joint_viscous + hand_damping);
        per_free_mass_ = 1.0 / free_mass_;
    }

    /// Equations 1 to 4 of docs/theory/diagnosis.md.
    void step(MotionState& s, const Torques& torques) const {
        const std::array<double, 2> pull{turn_capstan<0>(s, torques.agonist, torques.antagonist),
                                         turn_capstan<1>(s, torques.antagonist, torques.agonist)};
        turn_joint(s, pull, torques.joint);
        for (std::size_t i = 0; i < 3; ++i) s.place[i] += h_ * s.speed[i];
        for (std::size_t i = 0; i < 2; ++i)
            if (s.place[i] < 0.0) s.place[i] = s.speed[i] = 0.0;  // the preload stop
        if (backlash_) take_encoders_along(s);
    }

private:
    /// New speed of a capstan. @return torque of its K_SE [Nm of nominal capstan]
    template <std::size_t kSide>
    double turn_capstan(MotionState& s, double command, double other_command) const {
        const BuiltSide& side = rig_.sides[kSide];
        const double theta = s.place[kSide], wound = side.capstan_scale * theta, stretch = side.ratio * wound_on_joint(s.place[2]);
        const double x = (kSide == 0 ? wound + stretch : wound - stretch) - s.slipped[kSide];
        double pull = s.memory[2 * kSide].torque(x, side.se.torque(x), side.se_build.hysteresis);
        double parallel = s.memory[2 * kSide + 1].torque(theta, side.pe.torque(theta), side.pe_build.hysteresis);
        if (memory_) remember<kSide>(s, pull, parallel);
        double extra = 0.0, factor = drifted_[kSide];
        if (const GearTerms& terms = side.gear.terms; terms.move()) {
            extra = terms.torque(theta) + terms.crosstalk * other_command;
            factor *= std::max(0.0, 1.0 + terms.friction(theta));
        }
        const double load = side.capstan_scale * pull + parallel;
        s.speed[kSide] = gear_speed(side, per_mass_[kSide], s.speed[kSide], load, {command, extra, factor});
        return pull;
    }
    void take_encoders_along(MotionState& s) const {
        for (std::size_t i = 0; i < 2; ++i) {
            const double half = 0.5 * rig_.sides[i].gear.backlash;
            s.encoder[i] = std::clamp(s.encoder[i], s.place[i] - half, s.place[i] + half);
        }
    }
    /// Relaxation of both springs and slip of the cable, from the torques of this step.
    template <std::size_t kSide>
    void remember(MotionState& s, double& pull, double& parallel) const {
        const BuiltSide& side = rig_.sides[kSide];
        const auto relax = [this](double& relaxed, double& torque, const SpringTerms& terms) {
            relaxed += h_ / (terms.relaxation_time + h_) * (torque - relaxed);
            torque = terms.relaxed(torque, relaxed);
        };
        relax(s.relaxed[2 * kSide], pull, side.se_terms);
        relax(s.relaxed[2 * kSide + 1], parallel, side.pe_terms);
        if (!s.jumped[kSide] && pull > side.se_terms.jump_at) {
            s.jumped[kSide] = true;
            s.slipped[kSide] += side.se_terms.jump;
        }
        s.slipped[kSide] += h_ * std::max(0.0, pull - side.se_terms.slip_at) / side.se_terms.slip_drag;
    }
    /// The joint angle that would wind as much cable on the nominal arm.
    [[nodiscard]] double wound_on_joint(double q) const { return rig_.terms.arm.is_on() ? q + rig_.terms.arm.integral(q) : q; }
    struct Drive {
        double command, extra, friction;  // [Nm], [Nm] of generic terms, factor of the friction
    };
    [[nodiscard]] double gear_speed(const BuiltSide& side, double per_mass, double before, double load, const Drive& drive) const {
        const Gear& gear = side.gear;
        const double torque = std::clamp(drive.command * (1.0 + gear.torque_scale), -gear.saturation, gear.saturation) + drive.extra;
        const double momentum = side.motor_inertia * before + h_ * (torque - load);
        const double way = momentum < 0.0 ? -1.0 : 1.0;
        const double sliding = h_ * drive.friction * (gear.coulomb + gear.load_friction * std::abs(load) + gear.quadratic * load * load) *
                               (1.0 + way * gear.asymmetry);
        const double left = std::abs(momentum) - sliding;
        if (left <= 0.0 || (left <= sliding * gear.stribeck && before * way <= 0.0)) return 0.0;
        double speed = left * per_mass;
        if (gear.stribeck > 0.0)
            for (int i = 0; i < 3; ++i) {
                const double share = speed / gear.stribeck_speed;
                speed = std::max(0.0, (left - sliding * gear.stribeck * std::exp(-share * share)) * per_mass);
            }
        return way * speed;
    }
    void turn_joint(MotionState& s, const std::array<double, 2>& pull, double command) const {
        const double q = s.place[2];
        const JointTerms& terms = rig_.terms;
        const std::array<double, 2> torque{rig_.sides[0].ratio * pull[0], rig_.sides[1].ratio * pull[1]};
        const double arm = terms.arm.is_on() ? 1.0 + terms.arm(q) : 1.0;
        double drive = arm * (torque[1] - torque[0]) + command + terms.torque_at(q);
        double per_mass = per_free_mass_;
        if (const double inside = std::abs(q) - rig_.stop; inside > 0.0) {
            drive -= std::copysign(rig_.stop_stiffness * inside, q);
            per_mass = 1.0 / (free_mass_ + h_ * 2.0 * rig_.stop_damping * std::sqrt(rig_.stop_stiffness * rig_.joint_inertia));
        }
        if (rig_.gravity != 0.0) drive -= rig_.gravity * std::sin(q);
        const double momentum = rig_.joint_inertia * s.speed[2] + h_ * drive;
        double friction = h_ * (rig_.joint_coulomb + rig_.tension_friction * (torque[0] + torque[1]));
        if (terms.friction.is_on()) friction = std::max(0.0, friction + h_ * terms.friction(q));
        s.speed[2] = std::copysign(std::max(0.0, std::abs(momentum) - friction), momentum) * per_mass;
    }

    const BuiltRig& rig_;
    double h_, free_mass_ = 1.0, per_free_mass_ = 1.0;
    bool memory_ = rig_.has_memory();
    bool backlash_ = rig_.sides[0].gear.backlash > 0.0 || rig_.sides[1].gear.backlash > 0.0;
    std::array<double, 2> per_mass_{}, drifted_{};  ///< the factor of the friction changes slowly: constant within these steps
};

}  // namespace

double step_on(const gap_case::Reference& reference, const gap_case::Protocol& protocol, double step) {
    const auto duration = [](const gap_case::Protocol& p) {
        return p.motor_ramp + p.motor_settle + p.dead_band_push + p.dead_band_release + p.joint_stiffness_phase + p.cocontraction_phase;
    };
    const double phases = duration(protocol) / duration({});
    return step * std::clamp(reference.time, phases / kStepRange, phases * kStepRange);
}

Motion::Motion(const BuiltRig& rig, double longest_step, double session) : rig_(&rig), longest_step_(longest_step), session_(session) {}

void Motion::lead_to(const Torques& torques, double seconds) {
    if (seconds <= 0.0) {
        torques_ = torques;
        return;
    }
    const int steps = std::max(1, static_cast<int>(std::ceil(seconds / longest_step_)));
    const bool held = torques_ == torques && !rig_->has_memory();
    const Stepper stepper(*rig_, hand_damping, seconds / steps, session_);
    MotionState state = state_;
    for (int i = 1; i <= steps && !(held && i > 1 && state.at_rest()); ++i)
        stepper.step(state, between(torques_, torques, static_cast<double>(i) / steps));
    state_ = state;
    torques_ = torques;
    session_ += seconds;
}

double Motion::encoder(gap_case::Side side) const {
    const auto i = static_cast<std::size_t>(side);
    return rig_->sides[i].gear.backlash > 0.0 ? state_.encoder[i] : state_.place[i];
}

void Motion::lead_smoothly_to(const Torques& torques, double seconds) {
    constexpr int kPieces = 24;
    const Torques from = torques_;
    for (int i = 1; i <= kPieces; ++i) {
        const double s = static_cast<double>(i) / kPieces;
        lead_to(between(from, torques, s * s * (3.0 - 2.0 * s)), seconds / kPieces);
    }
}

}  // namespace fusee::joint_model
