#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fusee/gap_case/reference.h"
#include "fusee/joint_model/cam_spring.h"

namespace fusee::joint_model {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

// Generic terms: laws for what no effect of the library describes (docs/theory/unknown.md). Each stands at a place of the joint and depends
// on one quantity; all are off in a new rig.

/// a sin(n x + phase).
struct Ripple {
    double amplitude = 0.0;
    double turns = 1.0;  ///< n [1/rad]
    double phase = 0.0;  ///< [rad]
    [[nodiscard]] bool is_on() const { return amplitude != 0.0; }
    [[nodiscard]] double operator()(double x) const { return amplitude * std::sin(turns * x + phase); }
    [[nodiscard]] double integral(double x) const {
        return amplitude / turns * (std::cos(phase) - std::cos(turns * x + phase));
    }  ///< from 0
};

/// a exp(-((x - at)/width)^2).
struct Bump {
    double height = 0.0, at = 0.0, width = 1.0;
    [[nodiscard]] bool is_on() const { return height != 0.0; }
    [[nodiscard]] double operator()(double x) const {
        const double away = (x - at) / width;
        return height * std::exp(-away * away);
    }
};

/// What settles within a session: d (1 - exp(-t/T)) at its time t.
struct Drift {
    double size = 0.0, time = 1.0;  ///< d; T [s]
    [[nodiscard]] bool is_on() const { return size != 0.0; }
    [[nodiscard]] double operator()(double session) const { return is_on() ? -size * std::expm1(-session / time) : 0.0; }
    [[nodiscard]] double factor(double session) const { return std::fmax(0.0, 1.0 + (*this)(session)); }  ///< of d as a share
};

/// Terms of a gear with its motor and capstan.
struct GearTerms {
    Ripple friction;         ///< friction is (1 + ripple) times, over the capstan angle
    Ripple torque;           ///< added to the motor torque [Nm], over the capstan angle
    Ripple reading;          ///< added to the capstan's encoder [rad], over the capstan angle
    double crosstalk = 0.0;  ///< share of the other motor's command that is added to the motor torque
    Drift friction_drift;    ///< of the friction, a share
    Drift torque_drift;      ///< of the torque that is delivered for a command, a share
    [[nodiscard]] bool move() const { return friction.is_on() || torque.is_on() || crosstalk != 0.0; }
};

/// Terms of a spring with its cam and cable.
struct SpringTerms {
    double slope = 0.0;                                        ///< torque is (1 + slope x/end) times
    Drift drift;                                               ///< of the torque, a share
    double relaxation = 0.0;                                   ///< a: share of the torque that is lost as held
    double relaxation_time = 1.0;                              ///< [s]
    double fast_share = 0.0;                                   ///< w: the law is that of the fast torque (0), or of the settled one (1)
    double slip_at = std::numeric_limits<double>::infinity();  ///< torque from which the cable slips on its capstan [Nm]
    double slip_drag = 1.0;                                    ///< slip speed is (torque - slip_at)/slip_drag [Nms/rad]
    double jump_at = std::numeric_limits<double>::infinity();  ///< torque at which the cable leaves its groove, once in a run [Nm]
    double jump = 0.0;                                         ///< and loses this [rad]
    [[nodiscard]] bool have_memory() const { return relaxation != 0.0 || std::isfinite(slip_at) || jump != 0.0; }
    /// Torque F (1 + a w) - a R, of the elastic one F and of R, which follows it with the time constant. [Nm]
    [[nodiscard]] double relaxed(double elastic, double following) const {
        return elastic * (1.0 + relaxation * fast_share) - relaxation * following;
    }
    /// Factor of the torque at `share` of the cam's end.
    [[nodiscard]] double factor(double share) const { return 1.0 + slope * share; }
};

/// Terms of the joint.
struct JointTerms {
    double spring = 0.0;       ///< to ground: torque -spring q [Nm/rad]
    double hardening = 0.0;    ///< torque -hardening q^3 [Nm/rad^3]
    Ripple torque;             ///< added to the joint torque [Nm], over q
    Ripple arm;                ///< both cables' arms at the joint are (1 + ripple) times, over q
    Bump friction;             ///< added to the joint friction [Nm], over q
    double drag = 0.0;         ///< torque -drag |q'|^power against the motion [Nm at 1 rad/s]
    double drag_power = 2.0;   ///< of the speed
    double reading = 0.0;      ///< the joint's encoder reads (1 + reading) q
    double flexibility = 0.0;  ///< and this times the joint torque more [rad/Nm]
    Drift zero;                ///< and this more [rad]
    double lag = 0.0;          ///< of a log: q was read so much earlier [s]
    double play = 0.0;         ///< of the link, which the encoder reads, on the pulley [rad]
    [[nodiscard]] bool has_torque() const { return spring != 0.0 || hardening != 0.0 || torque.is_on(); }
    [[nodiscard]] double torque_at(double q) const { return torque(q) - (spring + hardening * q * q) * q; }
    /// The drag over the speed [Nms/rad]. Below kSlow it is viscous.
    [[nodiscard]] double drag_at(double speed) const { return drag * std::pow(std::fmax(std::fabs(speed), kSlow), drag_power - 1.0); }
    static constexpr double kSlow = 0.01;  ///< [rad/s]
};

/// One motor with its gear, at the capstan.
struct Gear {
    double load_friction = 0.0;    ///< mu: friction mu |load|
    double coulomb = 0.0;          ///< constant friction [Nm]
    double quadratic = 0.0;        ///< friction that grows with the load squared [1/Nm]
    double asymmetry = 0.0;        ///< friction is (1 + a) times when winding in, (1 - a) times when paying out
    double stribeck = 0.0;         ///< s: at rest (1 + s) times the friction in motion
    double stribeck_speed = 0.05;  ///< v_s of s exp(-(v/v_s)^2) [rad/s]
    double viscous = 0.0;          ///< [Nms/rad]
    double backlash = 0.0;         ///< play between the capstan and the encoder of its motor [rad]
    double torque_scale = 0.0;     ///< delivered torque is (1 + e) times the command
    double saturation = kNever;    ///< greatest torque delivered [Nm]
    GearTerms terms;
};

/// Hand motion of the joint in a dead-band test. It is not measured: defaults from faultless rigs, fitted with the build tolerances.
struct Hand {
    double damping = 0.36;       ///< of the hand that follows the joint, of critical damping at that co-contraction
    double push_share = 0.72;    ///< share of dead_band_push in which the push rises; then it is held
    double settle_share = 0.11;  ///< share of dead_band_release between the end of the release and the reading of q
};

/// One side as built: springs are made of `se_build`, `pe_build` by BuiltRig::assemble.
struct BuiltSide {
    double ratio = 1.0;          ///< g = r_j/r_c, both as built over the nominal r_c
    double capstan_scale = 1.0;  ///< r_c as built over the nominal one
    double motor_inertia = 0.0;  ///< [kg m^2]
    Gear gear;
    SpringBuild se_build, pe_build;
    SpringTerms se_terms, pe_terms;
    CamSpring se, pe;
};

/// The rig of a prediction: the nominal rig with effects and build tolerances.
struct BuiltRig {
    explicit BuiltRig(const gap_case::NominalRig& nominal);

    gap_case::Reference reference;  ///< of the nominal rig
    std::array<BuiltSide, 2> sides;
    double joint_inertia = 0.0;     ///< [kg m^2]
    double joint_coulomb = 0.0;     ///< [Nm]
    double tension_friction = 0.0;  ///< c: friction c (g_1 F_SE1 + g_2 F_SE2) at the joint
    double joint_viscous = 0.0;     ///< [Nms/rad]
    double delay = 0.0;             ///< of every command of a log [s]
    double stop = kNever;           ///< |q| at which a stop begins [rad]
    double stop_stiffness = 60.0;   ///< of the stop, on the reference rig [Nm/rad]
    double stop_damping = 0.5;      ///< of the stop, of the critical one
    double gravity = 0.0;           ///< m g l: torque -m g l sin q [Nm]
    double joint_offset = 0.0;      ///< added to q as read [rad]
    Hand hand;
    JointTerms terms;
    /// What the joint's encoder reads [rad] at the angle q under a joint torque [Nm], at a time of the session [s].
    [[nodiscard]] double read_q(double q, double torque, double session) const {
        return (1.0 + terms.reading) * q + terms.flexibility * torque + joint_offset + terms.zero(session);
    }
    /// g of the joint as a whole, for a push that both sides share.
    [[nodiscard]] double mean_ratio() const { return 0.5 * (sides[0].ratio + sides[1].ratio); }
    /// A spring or cable depends on time: a joint at rest may still move.
    [[nodiscard]] bool has_memory() const;
    /// The rig changes within the session, so that a repeat reads something else.
    [[nodiscard]] bool drifts() const;

    /// Tabulates the springs. Call it after changing the builds.
    void assemble(const NominalCams& cams);
};

}  // namespace fusee::joint_model
