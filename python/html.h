#pragma once
#include <string>
#include <utility>
#include <vector>

#include "fusee/core/finding.h"

namespace fusee::python {

/// A result as a notebook shows it: heading, figures with their labels, and the findings that are broken or not judged.
[[nodiscard]] std::string html_of(const std::string& heading, const std::vector<std::pair<std::string, std::string>>& figures,
                                  const core::Findings& findings);

}  // namespace fusee::python
