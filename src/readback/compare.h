#pragma once
#include <filesystem>
#include <string>

#include "floor.h"
#include "fusee/readback/readback.h"

namespace fusee::readback {

/// Compares the arms of a taut cable over the floor with the requested ones.
[[nodiscard]] ArmError compare(const std::filesystem::path& path, const std::string& reader, const Floor& floor,
                               const exchange::PartFile& part);

}  // namespace fusee::readback
