#pragma once
#include <string>

#include "fusee/pipeline/springs.h"

/// Springs that can be wound or bought (docs/guides/find-springs.md).
namespace fusee::report {

/// Lines for a terminal: what was wanted, the springs that pass, and the rules that the others broke.
[[nodiscard]] std::string springs_text(const pipeline::SpringSearch& search);

}  // namespace fusee::report
