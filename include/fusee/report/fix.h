#pragma once
#include <string>

#include "fusee/search/fix.h"

/// The changes that a profile needs so that it can be made (docs/guides/fix.md).
namespace fusee::report {

using search::fix::Fix, search::fix::LostTorque, search::fix::MadeChange;
using FixConflict = search::fix::Conflict;

/// Keys as docs/guides/fix.md gives them.
[[nodiscard]] std::string fix_json(const Fix& fix);
/// Lines for a terminal.
[[nodiscard]] std::string fix_text(const Fix& fix);

}  // namespace fusee::report
