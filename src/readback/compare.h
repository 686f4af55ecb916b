#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "floor.h"
#include "fusee/readback/readback.h"

namespace fusee::readback {

/// Compares the arms of a taut cable over the floor with the requested ones.
[[nodiscard]] ArmError compare(const std::filesystem::path& path, const std::string& reader, const Floor& floor,
                               const exchange::PartFile& part);

/// The lever arm [mm] at every target row, with its sign (above 0 when the tension turns the cam by torque_sign): the body is turned to the
/// row's angle, and a taut cable is laid from the guide over the floor. Of all lines through the guide at half a cable from a floor point,
/// the one with the largest moment is tangent to the whole floor. NaN if no such line exists.
[[nodiscard]] std::vector<double> taut_arms(const Floor& floor, const exchange::PartFile& part);

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
