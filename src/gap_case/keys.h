#pragma once
#include "fusee/gap_case/case.h"
#include "fusee/gap_case/toml.h"

/// The numbers of a case.toml, table by table, each with what it may be: what reading and the empty template walk.
namespace fusee::gap_case {

[[nodiscard]] std::vector<NumberKey> rig_keys(NominalRig& rig);
[[nodiscard]] std::vector<NumberKey> tolerance_keys(Tolerance& tolerance);
[[nodiscard]] std::vector<NumberKey> sensor_keys(Sensors& sensors);
[[nodiscard]] std::vector<NumberKey> protocol_keys(Protocol& protocol);

}  // namespace fusee::gap_case
