#pragma once
#include <Eigen/Core>
#include <filesystem>
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
#include "fusee/report/outlook.h"

/// What a simulated joint does, to files that a program (JSON, CSV) or a person (HTML) reads (docs/simulation.md).
namespace fusee::report {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// The joint at one level of equal co-contraction. Widths are full widths at the joint.
struct SimulatedLevel {
    actuator::DeadBand dead_band;           ///< linear, exact and measured width [rad]
    actuator::ReleaseReading reading;       ///< of the push-and-release test that `dead_band.measured_width` comes from
    double within_laws = kUnknown;          ///< read after the strongest push on which no spring leaves its law [rad]
    Eigen::Matrix3d sensitivity;            ///< paper (2), d(theta_1, theta_2, q)/d(tau_1, tau_2, tau_q) [rad/Nm]; NaN: no springs hold it
    Eigen::Vector3d noise;                  ///< standard deviations of theta_1, theta_2, q under white torque noise [rad]; NaN: unbounded
    double frame = kUnknown;                ///< read with masses for motors, so with the bearing's friction only [rad]
    core::Range built{kUnknown, kUnknown};  ///< 5 to 95 % of joints as a shop builds them, exact extremes [rad]; NaN: not known
};

/// The level at `tau`, and the paper's joint beside its relatives, with nothing known.
[[nodiscard]] SimulatedLevel unknown_level(double tau);
[[nodiscard]] actuator::ArrangementRow unknown_survey();

/// One row of a table of measured dead-bands beside the three that are computed.
struct MeasuredRow {
    double tau = 0.0;       ///< [Nm]
    double measured = 0.0;  ///< [rad]
    actuator::DeadBand computed;
};

/// A place on the path of a push-and-release test.
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

/// Figure 8: what a motor subsystem shows when its load is lowered or raised until it breaks away.
struct BreakAwayRow {
    double motor_torque = 0.0;  ///< at the capstan [Nm]
    core::Range loads;          ///< least and greatest at rest [Nm]
};

/// The joint at rest under three torques (tau_1, tau_2, tau_q), in the signs of actuator::Joint. NaN where it does not rest.
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

/// What the cable of one spring takes of the capstan's travel at the law's largest load (docs/theory/cams.md, eq. 22).
struct StretchSide {
    cam::PartKind part;
    cam::ArmPoint at;
};

/// Everything that the files show. Of the paper's relatives only `survey` and the levels' linear figures are known.
struct Simulation {
    core::Provenance provenance;
    actuator::ArrangementRow survey;
    double push_torque = 0.0;              ///< asked for; 0: strong enough [Nm]
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
    std::vector<std::string> gaps;       ///< what could not be computed, and why
};

/// Why equilibria that were asked for do not exist; empty if all do.
[[nodiscard]] core::Findings refusals(const Simulation& simulation);

[[nodiscard]] ConditionVerdict condition_verdict(const Simulation& simulation);
/// Where the linear, the exact and the read dead-band part, in sentences with figures; and what the measured rows say.
[[nodiscard]] std::vector<std::string> remarks(const Simulation& simulation);

/// tau_Nm,linear_rad,extreme_rad,protocol_rad,condition_6,joint_stiffness_Nm_per_rad,capstan_rad with 17 digits, one row a level; nan where
/// the springs do not reach.
[[nodiscard]] std::string dead_band_csv(const std::vector<SimulatedLevel>& levels);
/// part,angle_rad,tau_Nm,tension_N,stretch_*_m,give_*_rad,width_rad with 17 digits, one row a working position.
[[nodiscard]] std::string wrap_hysteresis_csv(const std::vector<WrapSide>& wraps);
/// Width of both springs' loops together at one load of the capstan [rad]; NaN where a cam does not work.
[[nodiscard]] double wrap_width(const Simulation& simulation, double tau);
/// What the cables' loops lose, and their share in the dead-band, in a sentence. @pre simulation.wraps not empty
[[nodiscard]] std::string wrap_remark(const Simulation& simulation);
/// What the cables' stretch takes of the capstan's travel, in a sentence. @pre simulation.stretches not empty
[[nodiscard]] std::string stretch_remark(const Simulation& simulation);
/// The keys of docs/simulation.md, in that order; a NaN is null.
[[nodiscard]] std::string simulation_json(const Simulation& simulation);
/// One page in one file that opens offline: no script, no request.
[[nodiscard]] std::string simulation_html(const Simulation& simulation);
/// The paper's comparison of arrangements: one row each, the unit at the end of the column's name.
[[nodiscard]] std::string relatives_csv(const std::vector<Simulation>& simulations);
/// The levels as a table for a terminal, with measured rows and remarks below.
[[nodiscard]] std::string simulation_text(const Simulation& simulation);
/// Stiffness range, torque range and dead-band of several joints as a table for a terminal.
[[nodiscard]] std::string survey_text(const std::vector<Simulation>& simulations);

}  // namespace fusee::report
