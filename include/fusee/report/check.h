#pragma once
#include <string>

#include "fusee/pipeline/check.h"

namespace fusee::report {

using pipeline::binding, pipeline::Checked, pipeline::CheckedPart, pipeline::CheckedProcess;

/// One process: its findings but passes, as `fusee make` prints them. Several: a table, one line a process and part.
[[nodiscard]] std::string check_text(const Checked& checked);
/// The keys of docs/guides/check.md, in that order.
[[nodiscard]] std::string check_json(const Checked& checked);

}  // namespace fusee::report
