#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fusee/plant/effects.h"
#include "fusee/plant/experiments.h"

namespace fusee::plant {

/// Relative path to bytes: case.toml, nominal_springs.csv, the six experiments, and the same six under heldout/.
using CaseFiles = std::map<std::string, std::string>;

[[nodiscard]] std::string case_toml(const TestRig& test_rig);
[[nodiscard]] std::string springs_csv(const Nominal& nominal);
/// The six CSV files of the format, by name.
[[nodiscard]] CaseFiles experiment_files(const Measured& measured);

/// The rig of a case: drawn from (seed, index), without its effects; its figures as designed do not depend on them.
[[nodiscard]] TestRig draw_test_rig(std::uint64_t seed, std::uint64_t index);
/// A whole case. Every byte follows from the arguments. @throws core::InvalidInput as `apply` does
[[nodiscard]] CaseFiles make_case(std::uint64_t seed, std::uint64_t index, const std::vector<Effect>& effects);

}  // namespace fusee::plant
