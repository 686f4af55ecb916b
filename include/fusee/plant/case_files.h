#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fusee/plant/machine.h"
#include "fusee/plant/rig.h"

/// Effects, the six experiments on the rig as built as its sensors see them, and the files of a case.
namespace fusee::plant {

/// An effect that the nominal model does not have. Ids of the case format, or "outside.NAME".
struct Effect {
    std::string id;
    std::string side = "none";                                      ///< agonist, antagonist or both; none for effects without sides
    double size = 0.0;                                              ///< in the unit that the format gives for the id
    std::vector<std::pair<std::string, double>> extra;              ///< further parameters of its law, by name
    [[nodiscard]] double parameter(const std::string& name) const;  ///< @pre it has one
};

/// Ids of the format, those of figures that case.toml states wrongly, ids outside of it that a generic term of the diagnosis has the
/// equation of, ids outside that nothing there has, and those that only another engine's rig has, in fixed order.
[[nodiscard]] const std::vector<std::string>& library_ids();
[[nodiscard]] const std::vector<std::string>& figure_ids();
[[nodiscard]] const std::vector<std::string>& outside_ids();
[[nodiscard]] const std::vector<std::string>& form_blind_ids();
[[nodiscard]] const std::vector<std::string>& engine_ids();

/// Side and size at random, well above tolerance and noise on this rig.
/// @throws core::InvalidInput "effect" if no list has the id
[[nodiscard]] Effect draw_effect(const std::string& id, const Nominal& nominal, Random& random);
/// Applies it to the rig. @throws core::InvalidInput "effect" or "effect.side"
void apply(const Effect& effect, Truth& truth);

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
[[nodiscard]] Measured measure(const TestRig& test_rig, const SetPoints& points, Random& random, double session = 0.0,
                               const Engine& engine = {});

/// Relative path to bytes: case.toml, nominal_springs.csv, the six experiments, and the same six under heldout/.
using CaseFiles = std::map<std::string, std::string>;

/// @param experiments those that it lists; empty: all six
[[nodiscard]] std::string case_toml(const TestRig& test_rig, const std::vector<std::string>& experiments = {});
[[nodiscard]] std::string springs_csv(const Nominal& nominal);
/// The six CSV files of the format, by name.
[[nodiscard]] CaseFiles experiment_files(const Measured& measured);

/// What is unusual about a case beside its effects.
struct Conditions {
    bool linear_springs = false;
    double noise = 1.0;                    ///< of encoders and torque sensors, times what case.toml states
    std::vector<std::string> experiments;  ///< "log", "dead_band", ...: the only ones of the fit; empty: all six
    [[nodiscard]] bool operator==(const Conditions&) const = default;
};

/// The rig of a case: drawn from (seed, index), without its effects; its figures as designed do not depend on them.
[[nodiscard]] TestRig draw_test_rig(std::uint64_t seed, std::uint64_t index, bool linear_springs = false);
/// A whole case. Every byte follows from the arguments. @throws core::InvalidInput as `apply` does
[[nodiscard]] CaseFiles make_case(std::uint64_t seed, std::uint64_t index, const std::vector<Effect>& effects, const Engine& engine = {},
                                  const Conditions& conditions = {});

}  // namespace fusee::plant
