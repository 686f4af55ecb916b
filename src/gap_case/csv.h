#pragma once
#include <functional>
#include <string_view>

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

}  // namespace fusee::gap_case
