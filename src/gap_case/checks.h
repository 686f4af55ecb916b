#pragma once
#include <string>
#include <vector>

#include "fusee/gap_case/case.h"

namespace fusee::gap_case {

/// Checks on many rows together, or on rows against the rig: wrong unit, sign or side, a spring rate that
/// contradicts the spring curves. Returns remarks on what is tolerated.
/// @throws core::InvalidInput "FOLDER/FILE: column" where the values cannot be used
/// @param springs the name of the springs' file in the folder
[[nodiscard]] std::vector<std::string> check_rows(const Case& gap_case, const std::filesystem::path& folder, const std::string& springs);

/// Travel of the base springs: spool angle and compression at the end of the nominal curves, from the energies
///     1/2 k_t phi^2 = U_SE, 1/2 k y^2 = U_PE.
struct BaseTravel {
    double spool_angle = 0.0;  ///< phi [rad]
    double compression = 0.0;  ///< y [m]
};
[[nodiscard]] BaseTravel base_travel(const NominalRig& rig);

}  // namespace fusee::gap_case
