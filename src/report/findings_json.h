#pragma once
#include <nlohmann/json.hpp>

#include "fusee/core/finding.h"

namespace fusee::report {

/// Findings as every JSON file shows them (docs/report.md).
[[nodiscard]] nlohmann::ordered_json findings_json(const core::Findings& findings);

}  // namespace fusee::report
