#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/gap_case/toml.h"
#include "fusee/subsystem/subsystem.h"

/// Files with the nominal law of a cam: q_rad ascending, torque_Nm.
namespace fusee::subsystem {

/// True for a CSV file with the columns of a law and no time. @throws core::IoError
[[nodiscard]] bool is_law_file(const std::filesystem::path& file, const core::CsvMapping& columns);

/// @param bytes gets the file's bytes at its end
/// @throws core::InvalidInput "file:line:column: q_rad" if angles do not ascend; core::IoError
[[nodiscard]] LawCurve read_law(const std::filesystem::path& folder, const std::string& file, const core::CsvMapping& columns,
                                std::string& bytes);

/// Gives each record of a case its law: the file of its word `law=FILE`; law_X.csv for pull_X.csv; the file of experiments.law at the same
/// place, or its only one. @returns the bytes of the files. @throws core::InvalidInput naming the record that has none
[[nodiscard]] std::string read_laws(const gap_case::CaseToml& toml, const std::filesystem::path& folder, Case& subsystem_case);

/// The same for inputs, from the law files of their folder, then from those of the case. @throws as read_laws
void read_laws_of_inputs(const Case& subsystem_case, const std::filesystem::path& folder, const std::vector<std::filesystem::path>& laws,
                         Case& inputs);

}  // namespace fusee::subsystem
