#pragma once
#include <vector>

#include "fusee/core/units.h"
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

/// Body angles over which the floor carries the law [rad], the lower first: of a planar part within the turn from 0 on.
[[nodiscard]] core::Range working_angles(const cam::Cam& cam);

/// Length of the cable's centreline on the part, axial slope included [m].
struct CableLength {
    double working = 0.0;    ///< over the working arc: it winds and unwinds
    double to_anchor = 0.0;  ///< from there to the anchor: always wound
};
/// By chords of a thousandth of a turn, corrected to arcs: relative error below 1e-9 on a smooth path, 1e-6 where its curvature jumps.
[[nodiscard]] CableLength cable_length(const cam::Cam& cam);

}  // namespace fusee::drawing
