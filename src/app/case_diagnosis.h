#pragma once
#include <filesystem>

#include "fusee/diagnosis/diagnose.h"

namespace fusee::app {

/// Is the case in a folder that of a whole joint? @throws as the reader of case.toml
[[nodiscard]] bool is_joint_case(const std::filesystem::path& folder);

/// The diagnosis of the case in a folder, whatever it is of: a joint, a subsystem, a simulator of the user's own.
/// @throws core::InvalidInput naming the folder; as the readers of the cases
[[nodiscard]] diagnosis::Diagnosis diagnosis_of(const std::filesystem::path& folder, const diagnosis::DiagnoseOptions& options);

}  // namespace fusee::app
