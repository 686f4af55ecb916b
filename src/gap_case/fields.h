#pragma once
#include <string>
#include <vector>

#include "fusee/gap_case/case.h"
#include "fusee/gap_case/toml.h"

/// The columns of the experiment files: one list for reading, checking, writing and the empty templates.
namespace fusee::gap_case {

/// Physical quantity of a column: decides which values are rejected as another unit.
enum class Quantity { kWord, kCount, kTime, kDeflection, kCapstanAngle, kJointAngle, kPull, kTorque, kJointTorque };

template <class Row>
struct Field {
    const char* column;
    bool measured = false;  ///< else commanded: an input
    bool required = true;   ///< the column may be missing: values keep their defaults
    Quantity quantity = Quantity::kWord;
    double (*get)(const Row&) = nullptr;  ///< for a word: its index in `words`
    void (*set)(Row&, double) = nullptr;
    std::vector<std::string> words{};
};

/// The fields in the order of the header line.
template <class Row>
const std::vector<Field<Row>>& fields();
template <>
const std::vector<Field<BreakAway>>& fields();
template <>
const std::vector<Field<SpringPull>>& fields();
template <>
const std::vector<Field<DeadBandRow>>& fields();
template <>
const std::vector<Field<StiffnessRow>>& fields();
template <>
const std::vector<Field<CocontractionRow>>& fields();
template <>
const std::vector<Field<LogRow>>& fields();

/// Calls visit(Experiment, std::vector<Row>&) for each experiment.
template <class AnyRows, class Visit>
void for_each_experiment(AnyRows& rows, const Visit& visit) {
    visit(Experiment::kBreakAway, rows.breakaway);
    visit(Experiment::kSpringPull, rows.spring_pull);
    visit(Experiment::kDeadBand, rows.dead_band);
    visit(Experiment::kJointStiffness, rows.joint_stiffness);
    visit(Experiment::kCocontraction, rows.cocontraction);
    visit(Experiment::kLog, rows.log);
}

// The numbers of a case.toml, table by table, with their ranges: one list for reading and for the empty template.

/// Limits of values with a torque in their unit are those of the reference rig times the torque of this one: beyond them a value is in
/// another unit, on a rig of any size.
[[nodiscard]] std::vector<NumberKey> on_rig(std::vector<NumberKey> keys, const NominalRig& rig);
[[nodiscard]] std::vector<NumberKey> rig_keys(NominalRig& rig);
[[nodiscard]] std::vector<NumberKey> tolerance_keys(Tolerance& tolerance);
[[nodiscard]] std::vector<NumberKey> sensor_keys(Sensors& sensors);
[[nodiscard]] std::vector<NumberKey> protocol_keys(Protocol& protocol);

}  // namespace fusee::gap_case
