#pragma once
#include <string>

#include "fusee/profile/profile.h"

namespace fusee::profile {

/// Fills in every table that the profile names, in this order: gear friction, law, measured dead-band. Returns their bytes, joined.
/// @throws core::IoError; core::InvalidInput "file:line:column: tau_Nm"
[[nodiscard]] std::string read_files(Profile& profile);

}  // namespace fusee::profile
