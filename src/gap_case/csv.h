#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/gap_case/case.h"
#include "fusee/gap_case/files.h"

namespace fusee::gap_case {

/// How the files of a folder are read.
struct TablesOptions {
    bool inputs_only = false;  ///< measured columns, and whole files, may be missing; nothing is thinned
    std::function<void(std::string_view)> seen = [](std::string_view) {};  ///< receives every byte read
    std::vector<std::string>* remarks = nullptr;                           ///< receives one for each thinned file
};

/// The files of `gap_case.files` among `files`, checked against `gap_case.rig`.
/// @throws core::InvalidInput "file:line:column: column", core::IoError
[[nodiscard]] Rows read_tables(const Case& gap_case, const CaseFiles& files, const TablesOptions& options);

/// Columns deflection_rad, se_torque_Nm, pe_torque_Nm: 8 rows or more, ascending from 0, torques never falling from 0.
[[nodiscard]] std::vector<NominalRig::SpringRow> read_springs(const CaseFiles& files, const std::string& file,
                                                              const std::function<void(std::string_view)>& seen);

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
