#pragma once
#include <filesystem>
#include <vector>

#include "fusee/blind/score.h"

namespace fusee::blind {

/// The cases of a benchmark: its folders that hold a case.toml, by name; the first `limit` of them, 0: all.
/// @throws core::InvalidInput "folder" if it has none
[[nodiscard]] std::vector<std::string> case_names(const std::filesystem::path& folder, std::size_t limit);

/// Diagnoses a case on one thread and measures its gap on heldout/, or reads the existing result for the same case in FOLDER/diagnoses.
/// Opens only the folder of the case. A case that cannot be diagnosed gives an answer with `failure`.
/// @throws core::IoError if results cannot be written, core::Stopped
[[nodiscard]] Answer answer_case(const ScoreOptions& options, const std::string& name);

}  // namespace fusee::blind
