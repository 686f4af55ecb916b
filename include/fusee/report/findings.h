#pragma once
#include <string>

#include "fusee/core/finding.h"

namespace fusee::report {

/// An array of findings as every JSON file shows them (docs/report.md).
[[nodiscard]] std::string findings_list_json(const core::Findings& findings);

}  // namespace fusee::report
