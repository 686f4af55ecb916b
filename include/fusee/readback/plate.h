#pragma once
#include <filesystem>
#include <vector>

#include "fusee/exchange/plate.h"
#include "fusee/readback/readback.h"

namespace fusee::readback {

/// Reads the plate's 3MF in `folder`: each object moved back to its part's frame and its arm recomputed as `read_back` does, against
/// NAME.json there. One error for each object, reader "lib3mf NAME".
/// @throws IoError if a file cannot be read, the 3MF has not the stated SHA-256, triangles and objects, or two objects' bounding boxes are
/// nearer than the spacing or out of the build volume
[[nodiscard]] std::vector<ArmError> read_back_plate(const std::filesystem::path& folder, const exchange::Plate& plate);

}  // namespace fusee::readback
