#pragma once
#include <array>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/solid/part.h"

namespace fusee::solid {

using Point2 = std::array<double, 2>;
using Ring = std::vector<Point2>;  ///< closed polygon [mm], counter-clockwise, first point not repeated

/// Inscribed polygon of a circle about (x, y) that stays within `tolerance_mm` of it; its first vertex at angle 0.
[[nodiscard]] Ring circle_ring(double radius_mm, double tolerance_mm, Point2 centre_mm = {});
/// The bore with its keyway or flat; key and flat towards +x, where the timing mark is.
[[nodiscard]] Ring bore_ring(const HubOptions& hub, double tolerance_mm);
/// Largest distance of the bore's outline from the axis (corner of the key) [mm].
[[nodiscard]] double bore_reach_mm(const HubOptions& hub);

/// Point of a flange's outline at normal direction psi, and its radius of curvature there [mm].
struct OutlinePoint {
    Point2 point{};
    double rho = 0.0;
};
/// The pitch curve's parallel at `offset_mm`, widened to hold a circle of `core_radius_mm` about the axis (0 = none): Firey's p-sum of the
/// two support functions, convex and as smooth as they are (Firey 1962).
[[nodiscard]] OutlinePoint flange_point(const cam::PathPoint& path, double offset_mm, double core_radius_mm);

}  // namespace fusee::solid
