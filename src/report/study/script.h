#pragma once
#include <string_view>

/// The parts of a study's page that do not depend on the study.
namespace fusee::report {

[[nodiscard]] std::string_view study_style();
[[nodiscard]] std::string_view study_body();
/// Reads `data`: columns, rows, has_reports.
[[nodiscard]] std::string_view study_script();

}  // namespace fusee::report
