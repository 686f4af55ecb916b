#pragma once
#include <array>
#include <functional>
#include <vector>

#include "fusee/checks/check.h"

namespace fusee::checks {

using Vec2 = std::array<double, 2>;  ///< [m], body frame

/// The cable's path by rising psi over the whole groove: the working positions as they are and, cheaper than solving for them again, the
/// path's own points where no cable works.
std::vector<cam::PathPoint> contour(const cam::Cam& cam);

/// The working position at which `badness` is largest; not a number is worse than any. @pre some position works
const cam::Contact& worst_contact(const cam::Cam& cam, const std::function<double(const cam::Contact&)>& badness);

/// A distance [m] and the contour's point where it is found.
struct Nearest {
    double distance = 0.0;
    cam::PathPoint at;
};
/// Least distance from `q`, inside, to the convex curve at `offset` from the path: min over psi of h + offset - q.n. Below 0: q is outside.
Nearest distance_inside(const std::vector<cam::PathPoint>& path, double offset, Vec2 q);

/// The bore as cut, clearance included.
double bore_radius(const solid::HubOptions& hub);
/// The keyway's outer corners, towards +x; empty without one.
std::vector<Vec2> key_corners(const solid::HubOptions& hub);
/// From `q`, outside, to the edge of bore or keyway.
double distance_to_bore(const solid::HubOptions& hub, Vec2 q);

/// The spring-leg slot: all points within `radius` of a radial segment.
struct Slot {
    Vec2 inner, outer;  ///< the segment's ends
    double radius;      ///< half the slot's width
    /// From `q` to the slot's edge; below 0 inside.
    [[nodiscard]] double distance(Vec2 q) const;
};
bool has_slot(const solid::FeatureOptions& features);
Slot leg_slot(const solid::FeatureOptions& features);

/// The groove's section [m]: width between the lips, height of the lips above the floor, lips from the cable's centreline.
/// @pre part.section holds at least two points
double groove_width(const solid::Part& part);
double lip_offset(const solid::Part& part);

/// Least height from one turn to the next, at the same direction [m]; `turns` is false where no turn has a neighbour.
struct Pitch {
    bool turns = false;
    double least = 0.0;
    cam::PathPoint at;
};
Pitch least_pitch(const cam::Cam& cam);

}  // namespace fusee::checks
