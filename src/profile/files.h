#pragma once
#include <string>

#include "fusee/core/toml_faults.h"
#include "fusee/profile/profile.h"

namespace fusee::profile {

/// Reads every table that the profile names, in this order: gear friction, law, springs' catalogue, measured dead-band. Returns their
/// joined bytes.
/// @param faults gets the faults of each: an unreadable file at its key, a cell as "file:line:column: tau_Nm"
[[nodiscard]] std::string read_files(Profile& profile, core::TomlFaults& faults);

}  // namespace fusee::profile
