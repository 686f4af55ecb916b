#pragma once
#include <string>

#include "fusee/gap_case/case_template.h"

namespace fusee::gap_case {

/// The text of BENCH.md: how to do each experiment of the template, with its set points. Markdown.
[[nodiscard]] std::string experiment_sheets(const CaseTemplate& empty, const Rows& rows);

}  // namespace fusee::gap_case
