#pragma once
#include <string>

#include "faults.h"
#include "fusee/profile/profile.h"

namespace fusee::profile {

/// Fills in every table that the profile names, in this order: gear friction, law, springs' catalogue, measured dead-band. Returns their
/// bytes, joined.
/// @param faults gets what is wrong with each: a file that cannot be read at its key, a cell as "file:line:column: tau_Nm"
[[nodiscard]] std::string read_files(Profile& profile, Faults& faults);

}  // namespace fusee::profile
