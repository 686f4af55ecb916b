#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>

#include "fusee/diagnosis/diagnose.h"
#include "fusee/gap_case/case.h"

namespace fusee::app {

/// What the case in a folder is of; with a file of a simulator's model it is that simulator's. @throws as gap_case::kind_of_case
[[nodiscard]] gap_case::CaseKind kind_with(const std::filesystem::path& folder, const std::filesystem::path& own_model);

/// The diagnosis of the case in a folder, whatever it is of: a joint, a subsystem, a simulator of the user's own.
/// @param against folder of another case of the same model, on which its causes are tried; "": none
/// @param own_model file of a simulator's model, in place of what the cases say; "": none
/// @throws core::InvalidInput naming the folder; as the readers of the cases; naming --against if it is of another model
[[nodiscard]] diagnosis::Diagnosis diagnosis_of(const std::filesystem::path& folder, const diagnosis::DiagnoseOptions& options,
                                                const std::filesystem::path& against = {}, const std::filesystem::path& own_model = {});

/// --model: `own_model` of the functions above.
void add_model(CLI::App& command, std::filesystem::path& model);

}  // namespace fusee::app
