#pragma once
#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/relatives.h"
#include "fusee/actuator/stick_slip.h"
#include "fusee/cam/wrap_friction.h"
#include "fusee/core/finding.h"
#include "fusee/core/provenance.h"
#include "fusee/core/units.h"

/// The simulated joint (docs/simulation.md).
namespace fusee::pipeline {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// The dead-band at one co-contraction, and the width that a push-and-release test measures.
struct SimulatedDeadBand : actuator::DeadBand {
    double measured_width = kUnknown;  ///< full width at the joint [rad]
};

/// The joint at one level of equal co-contraction. Widths are full widths at the joint.
struct SimulatedLevel {
    SimulatedDeadBand dead_band;            ///< linear, exact and measured width [rad]
    actuator::ReleaseReading reading;       ///< of the push-and-release test that `dead_band.measured_width` comes from
    double within_laws = kUnknown;          ///< measured after the strongest push at which every spring stays inside its law [rad]
    Eigen::Matrix3d sensitivity;            ///< paper (2), d(theta_1, theta_2, q)/d(tau_1, tau_2, tau_q) [rad/Nm]; NaN: no springs hold it
    Eigen::Vector3d noise;                  ///< standard deviations of theta_1, theta_2, q under white torque noise [rad]; NaN: unbounded
    double frame = kUnknown;                ///< measured with masses in place of the motors: friction of the bearing only [rad]
    core::Range built{kUnknown, kUnknown};  ///< 5 to 95 % of joints as a shop builds them, exact extremes [rad]; NaN: not known
};

/// A level and a survey of which nothing is known.
[[nodiscard]] SimulatedLevel unknown_level(double tau);
[[nodiscard]] actuator::ArrangementRow unknown_survey();

/// One row of a table of measured dead-bands, with the three computed ones.
struct MeasuredRow {
    double tau = 0.0;       ///< [Nm]
    double measured = 0.0;  ///< [rad]
    SimulatedDeadBand computed;
};

/// A point on the path of a push-and-release test.
struct PathPoint {
    double joint_torque = 0.0;  ///< [Nm]
    double q = 0.0;             ///< [rad]
    double load_1 = 0.0;        ///< of the agonist's capstan [Nm]
    double load_2 = 0.0;        ///< of the antagonist's [Nm]
};
/// Push up, release, push down, release at one co-contraction.
struct ReleasePath {
    double tau = 0.0;           ///< [Nm]
    core::Range resting_loads;  ///< that stiction allows [Nm]
    std::vector<PathPoint> up, down;
};
/// Joint torque cycled until the path repeats: the last cycle.
struct DeflectionLoop {
    double tau = 0.0;  ///< [Nm]
    std::vector<PathPoint> cycle;
};

/// Figure 8: loads at which a resting motor subsystem breaks away.
struct BreakAwayRow {
    double motor_torque = 0.0;  ///< at the capstan [Nm]
    core::Range loads;          ///< least and greatest at rest [Nm]
};

/// The joint at rest under three torques (tau_1, tau_2, tau_q), with the signs of actuator::Joint. NaN if it does not rest.
struct EquilibriumRow {
    Eigen::Vector3d torque;                                              ///< asked for [Nm]
    Eigen::Vector3d z = Eigen::Vector3d::Constant(kUnknown);             ///< (theta_1, theta_2, q), paper (1) [rad]
    Eigen::Matrix3d sensitivity = Eigen::Matrix3d::Constant(kUnknown);   ///< paper (2) [rad/Nm]
    Eigen::Matrix3d cable_space = Eigen::Matrix3d::Constant(kUnknown);   ///< the same with the paper's hats [m/N]
    double joint_stiffness = kUnknown, free_joint_stiffness = kUnknown;  ///< capstans held; free [Nm/rad]
    std::optional<actuator::JointDeadBand> dead_band = {};               ///< without joint torque only
    core::Findings refusal = {};                                         ///< why it does not rest
};

/// The loop of one spring's cable on its cam (docs/theory/wrap_friction.md).
struct WrapSide {
    cam::PartKind part;
    cam::WrapLoop loop;
};

/// The part of the capstan's travel that one cable's stretch takes at the law's largest load (docs/theory/cams.md, eq. 22).
struct StretchSide {
    cam::PartKind part;
    cam::ArmPoint at;
};

/// The simulated joint. Of the paper's relatives only `survey` and the levels' linear figures are known.
struct Simulation {
    core::Provenance provenance;
    actuator::ArrangementRow survey;
    double push_torque = 0.0;              ///< asked for; 0: as strong as needed [Nm]
    actuator::ConditionSummary condition;  ///< (6) between the levels too
    std::vector<SimulatedLevel> levels;    ///< by rising co-contraction; at least 2
    std::vector<MeasuredRow> measured;
    std::vector<EquilibriumRow> equilibria;  ///< asked for
    std::optional<ReleasePath> path;         ///< at peak torque
    std::vector<DeflectionLoop> loops;
    std::vector<BreakAwayRow> break_away;
    std::vector<WrapSide> wraps;         ///< empty: the profile states no friction or stiffness of its cable
    std::vector<StretchSide> stretches;  ///< empty: no cable that stretches
    actuator::OutputFriction bearing;    ///< friction of the frame subsystem
    core::Findings findings;             ///< of the law
    std::vector<std::string> gaps;       ///< figures that could not be computed, and why
};

/// Reasons why equilibria do not exist; empty if all do.
[[nodiscard]] core::Findings refusals(const Simulation& simulation);

}  // namespace fusee::pipeline
