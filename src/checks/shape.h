#pragma once
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "fusee/checks/check.h"

namespace fusee::checks {

inline constexpr double kRopePitch = 2.065;  ///< least pitch of a rope's groove, in floor radii (Unirope/Python: up to 2.18)

using Vec2 = std::array<double, 2>;  ///< [m], body frame

/// The cable's path over the whole groove, by ascending psi: the working positions, and points of the path outside the working arc.
std::vector<cam::PathPoint> contour(const cam::Cam& cam);

/// The working position at which `badness` is largest; NaN is the worst. @pre some position works
const cam::Contact& worst_contact(const cam::Cam& cam, const std::function<double(const cam::Contact&)>& badness);

/// A distance [m] and the contour's point where it is found.
struct Nearest {
    double distance = 0.0;
    cam::PathPoint at;
};
/// Least distance from `q`, inside, to the convex curve at `offset` from the path: min over psi of h + offset - q.n. Below 0: q is outside.
Nearest distance_inside(const std::vector<cam::PathPoint>& path, double offset, Vec2 q);

/// Radius of the bore as cut, clearance included.
double bore_radius(const solid::HubOptions& hub);
/// The keyway's outer corners, towards +x; empty without one.
std::vector<Vec2> key_corners(const solid::HubOptions& hub);
/// Distance from the axis to the farthest point of bore and keyway.
double hub_radius(const solid::HubOptions& hub);
/// Distance from `q`, outside, to the edge of bore or keyway.
double distance_to_bore(const solid::HubOptions& hub, Vec2 q);

/// The spring-leg slot: all points within `radius` of a radial segment.
struct Slot {
    Vec2 inner, outer;  ///< the segment's ends
    double radius;      ///< half the slot's width
    /// Distance from `q` to the slot's edge; below 0 inside.
    [[nodiscard]] double distance(Vec2 q) const;
};
bool has_slot(const solid::FeatureOptions& features);
Slot leg_slot(const solid::FeatureOptions& features);

/// A round hole of the part.
struct Hole {
    double diameter, depth;  ///< [m]
    const char* what;
    const char* key;  ///< of its diameter in the profile, without the part's name
};
/// Bore, anchor hole and set screw's hole, as far as the part has them.
std::vector<Hole> holes(const solid::Part& part);
/// The hole with the largest depth over diameter.
Hole slenderest_hole(const solid::Part& part);
Hole smallest_hole(const solid::Part& part);
/// Length over which the bore holds the shaft [m].
double bore_length(const solid::Part& part);

/// Radius of the circle that the lips and flanges sweep at `p` as the cam turns [m].
double swept_radius(const solid::Part& part, const cam::PathPoint& p);
/// The point of the contour that sweeps the largest circle. @pre path not empty
const cam::PathPoint& farthest(const solid::Part& part, const std::vector<cam::PathPoint>& path);

/// Middle of the anchor hole, which touches the pitch curve from inside; none without hole or path.
struct AnchorHole {
    Vec2 centre;
    double radius;
    cam::PathPoint at;
};
std::optional<AnchorHole> anchor_hole(const solid::Part& part);

/// Wound angle from the cable's anchor to this contact [rad].
double wound_angle(const cam::Cam& cam, const cam::Contact& contact);
/// Slope of the groove, dz/ds, in the direction in which the cable leaves (with the tension's torque, along torque_sign t). @pre of working
double groove_slope(const cam::Cam& cam, const cam::Contact& contact);
/// Angle at which the free cable leaves its groove sideways [rad], above 0 upwards: from the contact's plane, the fleet angle of a grooved
/// drum; of a groove that is aimed at its guide, from the groove's own direction.
double fleet_from_groove(const cam::Cam& cam, const cam::Contact& contact);
/// Largest tension times arm over the working range: the torque that the hub transmits [Nm]. @pre some position works
double largest_torque(const cam::Cam& cam);

/// Largest angle from the vertical of the faces of the groove's upper half, which face down when the axis is upright [rad]. A flank of
/// throat T has 90 deg - T/2. @pre part.section holds at least two points
double largest_overhang(const solid::Part& part);
/// Half the groove's width at the height of the cable's centreline [m]. @pre as largest_overhang
double half_width_at_cable(const solid::Part& part);

/// Gap between the circle swept by lips and flanges and the guide, less half a cable [m]; below 0: collision; nothing for a guide without a
/// place.
std::optional<double> guide_gap(const solid::Part& part);

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
