#pragma once
#include <filesystem>
#include <string>

#include "floor.h"
#include "fusee/readback/readback.h"

namespace fusee::readback {

/// The arms that a taut cable over the floor has, against those asked for.
[[nodiscard]] ArmError compare(const std::filesystem::path& path, const std::string& reader, const Floor& floor,
                               const exchange::PartFile& part);

}  // namespace fusee::readback
