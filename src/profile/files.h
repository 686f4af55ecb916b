#pragma once
#include <string>

#include "fusee/core/toml.h"
#include "fusee/profile/profile.h"

namespace fusee::profile {

/// Reads every table that the profile names, in this order: gear friction, law, springs' catalogue, measured dead-band. Returns their
/// joined bytes.
/// @param faults gets the faults of each: an unreadable file at its key, a cell as "file:line:column: tau_Nm"
[[nodiscard]] std::string read_files(Profile& profile, core::TomlFaults& faults);

/// The table [columns]: names of columns in those files. @param faults gets a name that none of the tables has, and what is no text
void read_columns(const toml::node& node, core::TomlFaults& faults, core::CsvMapping& columns);
/// Its section of docs/profile.md.
[[nodiscard]] std::string columns_reference();

}  // namespace fusee::profile
