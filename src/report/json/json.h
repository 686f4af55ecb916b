#pragma once
#include <nlohmann/json.hpp>

#include "fusee/core/finding.h"

namespace fusee::report {

/// Findings as every JSON file shows them (docs/report.md).
[[nodiscard]] nlohmann::ordered_json findings_json(const core::Findings& findings);
/// How many passed, were not judged, are to be reviewed and are required, in all and by group.
[[nodiscard]] nlohmann::ordered_json rules_json(const core::Findings& findings);

}  // namespace fusee::report
