#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/report/report.h"
#include "fusee/toolpath/program.h"

namespace fusee::pipeline {

/// Writes the part's G-code beside `base` and adds a row for each file. Findings: what keeps the part from being milled, and, for a person
/// to know, that no interpreter is here to read the programs back.
[[nodiscard]] core::Findings write_programs(const solid::Part& part, const toolpath::Settings& settings, const std::string& provenance,
                                            const std::filesystem::path& base, std::vector<report::FileRow>& rows);

}  // namespace fusee::pipeline
