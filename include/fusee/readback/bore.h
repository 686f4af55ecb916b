#pragma once
#include <filesystem>

#include "fusee/exchange/part_file.h"

namespace fusee::readback {

/// Diameter of the hole about the axis in the lowest face of an STL file [mm], key and flat aside; for a compensated file, as made on the
/// machine of `part.compensated`.
/// @throws core::IoError if the file cannot be read or has no such hole
[[nodiscard]] double bore_mm(const std::filesystem::path& stl, const exchange::PartFile& part);

}  // namespace fusee::readback
