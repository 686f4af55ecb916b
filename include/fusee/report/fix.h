#pragma once
#include <string>

#include "fusee/fix/fix.h"

/// The changes that a profile needs so that it can be made (docs/guides/fix.md).
namespace fusee::report {

using fix::Fix, fix::LostTorque, fix::MadeChange;
using FixConflict = fix::Conflict;

/// Keys as docs/guides/fix.md gives them.
[[nodiscard]] std::string fix_json(const Fix& fix);
/// Lines for a terminal.
[[nodiscard]] std::string fix_text(const Fix& fix);

}  // namespace fusee::report
