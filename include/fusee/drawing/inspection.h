#pragma once
#include <array>
#include <vector>

#include "fusee/solid/part.h"

/// Points for the inspection of a finished part, and the length of its cable.
namespace fusee::drawing {

/// A place on the groove's floor (or a roller cam's rim) for a dial gauge or a ball of known radius.
struct FloorPoint {
    double angle = 0.0;    ///< body angle from the timing mark, counter-clockwise seen from +z; for a helix continued over its turns [rad]
    double radius = 0.0;   ///< distance of the floor's lowest point from the axis [m]
    double z = 0.0;        ///< height of that point [m]
    bool works = false;    ///< on the working arc: carries the law
    bool drilled = false;  ///< the anchor hole has removed the floor
};

/// The floor at every whole multiple of `step` [rad] of the body angle: one turn of a planar part, the whole groove of a helix.
/// @pre 0 < step; the floor encloses the axis (as in every part)
[[nodiscard]] std::vector<FloorPoint> inspect_floor(const solid::Part& part, double step);

/// Length of the cable's centreline on the part, axial slope included [m].
struct CableLength {
    double working = 0.0;    ///< over the working arc: it winds and unwinds
    double to_anchor = 0.0;  ///< from there to the anchor: always wound
};
/// Adds chords of a thousandth of a turn, corrected to arcs: the relative error is below 1e-9 on a smooth path, 1e-6 where its curvature
/// jumps.
[[nodiscard]] CableLength cable_length(const cam::Cam& cam);

/// A place on the working arc of the groove's floor (or of a roller cam's rim) for a measuring machine or a dial gauge along the normal.
struct CheckRow {
    double length = 0.0;               ///< of the floor's arc from the place of the least load, in the plane [m]
    double x = 0.0, y = 0.0, z = 0.0;  ///< of the floor's lowest point, body frame [m]
    double radius = 0.0;               ///< distance from the axis [m]
    double angle = 0.0;                ///< body angle as of FloorPoint, continued, not wrapped [rad]
    double normal = 0.0;               ///< direction of the outward normal, in the body frame; from `angle` by the tilt [rad]
    double arm = 0.0;                  ///< that the place gives as the cable (or roller) leaves there [m]
    /// The tilt of the normal against the radius [rad]: where the radius is off by dr, the arm is off by cos(tilt) dr.
    [[nodiscard]] double tilt() const { return normal - angle; }
};

inline constexpr std::size_t kCheckRows = 25;  ///< on the drawing and in the inspection sheet

/// `count` places at equal distances along the arc, from the place of the least load to that of the largest, both included.
/// @pre count > 1
[[nodiscard]] std::vector<CheckRow> check_rows(const solid::Part& part, std::size_t count = kCheckRows);

/// P and Q, the first and the last of them, without the length between them: that alone takes thousands of places of the arc.
[[nodiscard]] std::array<CheckRow, 2> arc_ends(const solid::Part& part);

/// Share of the arm that an angle error of the part on its shaft takes: largest |dr/da|/r of the working positions [1/rad].
[[nodiscard]] double arm_error_per_turn(const cam::Cam& cam);

}  // namespace fusee::drawing
