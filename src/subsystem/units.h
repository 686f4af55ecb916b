#pragma once
#include <filesystem>

#include "fusee/subsystem/subsystem.h"

namespace fusee::subsystem {

/// Asks about figures that contradict each other in the units of their columns: milliseconds, degrees, counts, grams, mNm, ...
/// @throws core::InvalidInput "FOLDER/FILE: column" with the question
void ask_units(const Case& subsystem_case, const std::filesystem::path& folder);

}  // namespace fusee::subsystem
