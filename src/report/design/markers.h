#pragma once
#include <array>
#include <string>
#include <vector>

#include "design/cam_drawing.h"

namespace fusee::report {

/// A dot for each rule that passed; for the others numbered discs, linked to their rows, on a circle of `radius_mm` about `centre_mm`, each
/// with a leader to its place, moved apart until they do not overlap.
/// @param size_mm radius of a disc
[[nodiscard]] std::string markers_svg(const std::vector<Marker>& markers, const std::array<double, 2>& centre_mm, double radius_mm,
                                      double size_mm);

/// The angles nearest to the wanted ones that keep a least distance, in the same order around the circle [rad].
[[nodiscard]] std::vector<double> spread_angles(std::vector<double> wanted, double least);

}  // namespace fusee::report
