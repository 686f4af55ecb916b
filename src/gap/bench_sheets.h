#pragma once
#include <string>

#include "fusee/gap/case_template.h"

namespace fusee::gap {

/// The text of BENCH.md: how each experiment of the template is done, with its set points. Markdown.
[[nodiscard]] std::string bench_sheets(const CaseTemplate& empty, const Rows& rows);

}  // namespace fusee::gap
