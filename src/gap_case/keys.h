#pragma once
#include "fusee/gap_case/case.h"
#include "fusee/gap_case/toml.h"

/// The numbers of a case.toml, table by table, with their ranges: one list for reading and for the empty template.
namespace fusee::gap_case {

/// Limits of values with a torque in their unit are those of the reference rig times the torque of this one: beyond them a value is in
/// another unit, on a rig of any size.
[[nodiscard]] std::vector<NumberKey> on_rig(std::vector<NumberKey> keys, const NominalRig& rig);
[[nodiscard]] std::vector<NumberKey> rig_keys(NominalRig& rig);
[[nodiscard]] std::vector<NumberKey> tolerance_keys(Tolerance& tolerance);
[[nodiscard]] std::vector<NumberKey> sensor_keys(Sensors& sensors);
[[nodiscard]] std::vector<NumberKey> protocol_keys(Protocol& protocol);

}  // namespace fusee::gap_case
