#pragma once
#include <filesystem>
#include <vector>

#include "floor.h"

namespace fusee::readback {

/// A point on the centreline of an outer bead of a print.
struct BeadPoint {
    Point xy_mm{};
    double z_mm = 0.0;  ///< middle of its layer, in the part's frame
    double width_mm = 0.0, height_mm = 0.0;
};

/// The external perimeters of a slicer's G-code, in the dialect of PrusaSlicer's comments (docs/theory/read_back.md).
struct Sliced {
    double layer_mm = 0.0;  ///< height of the thickest layer
    std::vector<BeadPoint> outer;
};
/// @throws IoError naming file and line: inches, relative coordinates, arcs, a missing number; no external perimeter; or no line with the
/// part's height
[[nodiscard]] Sliced read_sliced(const std::filesystem::path& gcode);

/// The beads under the cable, near its own height, each with the distance at which a round cable rests on its round nose.
[[nodiscard]] Floor sliced_floor(const Sliced& print, const exchange::PartFile& part);

}  // namespace fusee::readback
