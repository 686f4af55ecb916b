#pragma once
#include <string>
#include <vector>

#include "fusee/pipeline/design_report.h"

namespace fusee::report {

/// Names of the sheets for the inspection of the parts, as far as they were written.
[[nodiscard]] std::vector<std::string> inspection_sheets(const pipeline::DesignReport& design);
/// The bill of materials as a section of Markdown, for paper.
[[nodiscard]] std::string bill_table(const pipeline::DesignReport& design);

}  // namespace fusee::report
