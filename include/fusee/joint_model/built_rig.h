#pragma once
#include <array>
#include <functional>
#include <limits>
#include <vector>

#include "fusee/gap_case/reference.h"
#include "fusee/joint_model/cam_spring.h"
#include "fusee/joint_model/generic_terms.h"

namespace fusee::joint_model {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

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
    /// What the joint's encoder reads [rad] at the angle q under a joint torque [Nm].
    [[nodiscard]] double read_q(double q, double torque) const {
        return (1.0 + terms.reading) * q + terms.flexibility * torque + joint_offset;
    }
    /// g of the joint as a whole, for a push that both sides share.
    [[nodiscard]] double mean_ratio() const { return 0.5 * (sides[0].ratio + sides[1].ratio); }
    /// A spring or cable depends on time: a joint at rest may still move.
    [[nodiscard]] bool has_memory() const;

    /// Tabulates the springs. Call it after changing the builds.
    void assemble(const NominalCams& cams);
};

}  // namespace fusee::joint_model
