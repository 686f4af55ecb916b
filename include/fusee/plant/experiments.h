#pragma once
#include <string>
#include <vector>

#include "fusee/plant/machine.h"
#include "fusee/plant/range.h"

/// The format's six experiments on the rig as built, seen through its sensors.
namespace fusee::plant {

/// Where the experiments are taken: torques at the capstan [Nm].
struct SetPoints {
    std::vector<double> breakaway, dead_band, joint_stiffness;
    double log_torque = 0.7, log_swing = 0.35;  ///< co-contraction, and how far it goes from one motor to the other
    double log_slow = 0.2, log_fast = 1.0;      ///< the swing's frequencies, first and last [Hz]
    double log_knock = 0.75;                    ///< torque of the knock on the joint [Nm]
};
/// The set points of the fit, or those held out, for a top torque of 1.5 Nm times `scale`.
[[nodiscard]] SetPoints set_points(bool heldout, double scale);

struct BreakAwayRow {
    std::size_t side = 0;  ///< 0: agonist
    bool backdrive = true;
    double motor = 0.0, load = 0.0;
};
struct PullRow {
    bool series = true;
    std::size_t side = 0;
    bool load = true;
    double deflection = 0.0, torque = 0.0;
};
struct DeadBandRow {
    double cocontraction = 0.0;
    int repeat = 1;
    double push = 0.0, q_low = 0.0, q_high = 0.0;
};
struct StiffnessRow {
    double cocontraction = 0.0;
    std::string phase;
    double torque = 0.0, q = 0.0;
};
struct CocontractionRow {
    bool up = true;
    double motor = 0.0;
    std::array<double, 2> theta{};
    double q = 0.0;
};
struct LogRow {
    double time = 0.0;
    Command command;
    std::array<double, 2> theta{};
    double q = 0.0;
};
/// Recorded measurements.
struct Measured {
    std::vector<BreakAwayRow> breakaway;
    std::vector<PullRow> spring_pull;
    std::vector<DeadBandRow> dead_band;
    std::vector<StiffnessRow> joint_stiffness;
    std::vector<CocontractionRow> cocontraction;
    std::vector<LogRow> log;
};

/// A rig with its sensors and its protocol.
struct TestRig {
    Nominal nominal;
    Truth truth;
    Tolerance tolerance;
    Sensors sensors;
    Protocol protocol;
};

/// All six, one after the other in one session that begins at `session` [s]; equal arguments give equal rows.
[[nodiscard]] Measured measure(const TestRig& test_rig, const SetPoints& points, Random& random, double session = 0.0);

}  // namespace fusee::plant
