#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/core/folder.h"
#include "fusee/study/study.h"

namespace fusee::batch {

inline const std::vector<std::string> kStudyFiles{"study.toml", "index.csv", "index.sqlite", "index.html"};

/// out/NAME of a study (core::OutputFolder): study.toml and the index. Its folders designs, rows and slurm are written by many processes.
[[nodiscard]] core::OutputFolder study_folder(const study::Plan& plan, const std::filesystem::path& out, bool force,
                                              const std::string& command = "batch", std::vector<std::string> files = kStudyFiles);

/// Makes sure that out/NAME is this study's, so that a run which is killed can go on. @throws core::IoError
[[nodiscard]] core::OutputFolder claim_study_folder(const study::Plan& plan, const std::filesystem::path& out, bool force);

/// A copy of what the study was made from, in `folder`.
void write_study_file(const study::Plan& plan, const std::filesystem::path& folder);

}  // namespace fusee::batch
