#pragma once
#include <string>
#include <vector>

#include "fusee/gap_case/case.h"

namespace fusee::gap_case {

/// What only many rows together, or rows beside the rig, can show: another unit, a sign or a side the wrong way round, a spring rate that
/// does not go with the springs' curves. Returns what the reader should know and can live with.
/// @throws core::InvalidInput "FOLDER/FILE: column" where nothing sensible can be done with the figures
/// @param springs the name of the springs' file in the folder
[[nodiscard]] std::vector<std::string> check_rows(const Case& gap_case, const std::filesystem::path& folder, const std::string& springs);

/// How far the base springs move: spool angle and compression at the end of the nominal curves, from the energies
///     1/2 k_t phi^2 = U_SE, 1/2 k y^2 = U_PE.
struct BaseTravel {
    double spool_angle = 0.0;  ///< phi [rad]
    double compression = 0.0;  ///< y [m]
};
[[nodiscard]] BaseTravel base_travel(const NominalRig& rig);

}  // namespace fusee::gap_case
