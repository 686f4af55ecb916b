#pragma once
#include <array>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/part.h"

/// Flat outlines of a part, in its body frame.
namespace fusee::solid {

using Point2 = std::array<double, 2>;
using Ring = std::vector<Point2>;  ///< closed polygon [mm], counter-clockwise, first point not repeated

/// One piece of an exact outline: an arc from `begin` to `end` > `begin` [rad], or a corner where its radius is 0.
struct Arc {
    Point2 centre_mm{};
    double radius_mm = 0.0, begin = 0.0, end = 0.0;
    [[nodiscard]] Point2 at(double angle) const;
    [[nodiscard]] bool full() const;  ///< a whole circle
};
using Outline = std::vector<Arc>;  ///< counter-clockwise; each piece is joined to the next by a straight line, the last to the first

[[nodiscard]] Outline circle(double radius_mm, Point2 centre_mm = {});
/// Two half circles joined by straights: `length` overall along `angle` [rad], its middle at `radius` from the axis.
[[nodiscard]] Outline stadium(double width_mm, double length_mm, double radius_mm, double angle);
/// The bore with its keyway or flat; key and flat towards +x, where the timing mark is.
[[nodiscard]] Outline bore_outline(const HubOptions& hub);
/// The bore's outline without clearance: a shaft's where it has a flat. @pre its lock is a D-flat
[[nodiscard]] Outline flat_shaft_outline(const HubOptions& hub);
[[nodiscard]] double area_mm2(const Outline& outline);
/// The mirror image in y = 0.
[[nodiscard]] Outline mirrored_in_y(const Outline& outline);
/// Inscribed polygon that stays within `tolerance_mm` of the outline; that of a circle begins at angle 0.
[[nodiscard]] Ring ring_of(const Outline& outline, double tolerance_mm);
/// Is a point inside the polygon?
[[nodiscard]] bool holds(const Ring& ring, const Point2& point);
/// Largest distance of the bore's outline from the axis (corner of the key) [mm].
[[nodiscard]] double bore_reach_mm(const HubOptions& hub);

/// Point of a flange's outline at normal direction psi, and its radius of curvature there [mm].
struct OutlinePoint {
    Point2 point{};
    double rho = 0.0;
};
/// The pitch curve's parallel at `offset_mm`, widened to contain a circle of `core_radius_mm` about the axis (0 = none): Firey's p-sum of
/// the two support functions, convex and as smooth as they are (Firey 1962).
[[nodiscard]] OutlinePoint flange_point(const cam::PathPoint& path, double offset_mm, double core_radius_mm);

// Lines that a drawing shows of a part, in its body frame.

/// Closed polygons in which the plane z = `z_mm` cuts a closed mesh [mm]: a cut through the part as exported.
[[nodiscard]] std::vector<std::vector<std::array<double, 2>>> slice(const Mesh& mesh, double z_mm);

/// The pitch curve's parallel at `offset` [m] over `psi`, 720 points a turn and both ends [mm]; seen from +z for a helix.
[[nodiscard]] std::vector<std::array<double, 2>> parallel(const cam::Cam& cam, const core::Range& psi, double offset);

}  // namespace fusee::solid
