#pragma once
#include <filesystem>

#include "fusee/diagnosis/diagnose.h"

namespace fusee::app {

/// The diagnosis of the case in a folder, whatever it is of: a joint, a subsystem, a simulator of the user's own.
/// @param against folder of another case of the same model, on which its causes are tried; "": none
/// @param own_model file of a simulator's model, in place of what the cases say; "": none
/// @throws core::InvalidInput naming the folder; as the readers of the cases; naming --against if it is of another model
[[nodiscard]] diagnosis::Diagnosis diagnosis_of(const std::filesystem::path& folder, const diagnosis::DiagnoseOptions& options,
                                                const std::filesystem::path& against = {}, const std::filesystem::path& own_model = {});

}  // namespace fusee::app
