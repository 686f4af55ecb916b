#pragma once
#include <algorithm>
#include <array>
#include <optional>

#include "fusee/assembly/assembly.h"
#include "fusee/checks/limits.h"

namespace fusee::assembly {

/// Heights and positions from which the bodies of the agonist are made. Frame: that of the assembly, but z = 0 at the side's cables. [mm]
struct Layout {
    double cable = 0.0, gap = 0.0, wall = 0.0;
    double capstan = 0.0, joint = 0.0;  ///< radii to the cable's centreline
    double joint_bore = 0.0;            ///< reach of the pulley's bore with its lock from the axis
    double drum = 0.0;                  ///< half the width of a drum's groove
    double line = 0.0;                  ///< x of the cables between capstan and joint
    double turn = 0.0;                  ///< of a capstan from its lowest load: the working range of K_PE [rad]
    double spare = 0.0;                 ///< beyond both ends of that, to its stops: the carriage meets no bracket [rad]
    double plane = 0.0;                 ///< height of the agonist's cables in the assembly
    double carriage_half = 0.0;         ///< half the width of the carriage
    double carriage_rear = 0.0;         ///< from K_SE's axis to the outside of its rear wall
    double spool_reach = 0.0;           ///< radius of K_SE's body
    double spool_low = 0.0, spool_high = 0.0;
    double leg_post = 0.0;                         ///< from K_SE's axis to that of the post for its spring's leg
    double leg_post_angle = core::kPi;             ///< of that post about K_SE's axis, from +x [rad]
    LegSlot leg_slot;                              ///< of that post; no width: spring not stated
    double spring_low = 0.0, spring_length = 0.0;  ///< of the torsion spring: its lower end, and its length wound most
    double axle_end = 0.0;                         ///< highest point of the spool's axle
    double guide_distance = 0.0;                   ///< spool axis to the hole along y
    double idler = 0.0;                            ///< pitch radius of K_SE's idler; 0: a hole
    Eigen::Vector3d spool_axis, motor_axis;
    double base_high = 0.0;     ///< of the carriage's base plate
    double carriage_low = 0.0;  ///< lowest and highest points of carriage, rods and spool
    double carriage_high = 0.0;
    double top = 0.0, bottom = 0.0;  ///< ends of the rods along y
    double front = 0.0, rear = 0.0;  ///< y of the faces between which the carriage slides: of the frame's brackets, or the rods' ends
    bool frame = false;              ///< there is one: its plate is on the motors' side, above
    bool posts = false;              ///< of the frame, for K_PE's seats
    bool side_by_side = true;        ///< the carriages
    double arm_low = 0.0;            ///< of the motor shaft's bearing between K_PE and the capstan
    double plate = 0.0;              ///< of the frame: its lower face
    Eigen::Isometry3d k_se, k_pe;    ///< from the parts' frames
    double shaft_low = 0.0, shaft_high = 0.0;  ///< of the motor's
    Eigen::Vector3d k_pe_along;                ///< direction of its cable beyond the guide
    Eigen::Vector3d k_se_guide, k_pe_guide;
    double k_pe_spring_length = 0.0;  ///< at rest
};

/// The convex hull, counter-clockwise. @pre three points, not on one line
[[nodiscard]] solid::Ring hull_of(const solid::Ring& points);

inline constexpr double kChordal_mm = 0.02;   ///< of meshes of the bodies beside the cams, at most
inline constexpr double kFlange_mm = 2.0;     ///< thickness of a drum's flanges
inline constexpr double kRod_mm = 3.0;        ///< radius of the carriage's rods
inline constexpr double kRodWasher_mm = 3.5;  ///< radius of the washers on the brackets, at the rods' ends (ISO 7089, M3)
inline constexpr double kRodThread_mm = 8.0;  ///< depth of the threads M3 in their ends
inline constexpr double kBush_mm = 6.0;       ///< radius of its linear bushes (ISO 10285, 6 x 12 x 19)
inline constexpr double kBushLength_mm = 19.0;
inline constexpr double kHousing_mm = 8.5;  ///< half the width of a bush's housing: 2.5 mm of wall around the bush (practice)
inline constexpr double kLegPost_mm = 2.0;  ///< half the post for the torsion spring's leg, in the leg's direction
inline constexpr double kProng_mm = 2.0;    ///< on each side of its slot
inline constexpr double kLegPlay_mm = 0.2;  ///< of the leg in that slot: rule assembly.leg_width allows 0 to 0.5 mm
inline constexpr double kCap_mm = 3.0;      ///< thickness of the cap on K_PE's spring
inline constexpr double kAxleEnd_mm = 2.0;  ///< of the spool's axle beyond what it holds, with the groove of a retaining ring
inline constexpr double kScrewHole_mm = 1.7,
                        kScrewHead_mm = 2.75;   ///< radii of the clearance hole and the head of a screw of seat or link, M3 (ISO 4762)
inline constexpr double kSeatSpace_mm = 0.3;    ///< of such a head beside the spring
inline constexpr double kStop_mm = 2.0;         ///< radius of the joint's stop pin and posts
inline constexpr double kStopOverlap_mm = 6.0;  ///< of pin and posts, at most; as deep the posts are in the frame
inline constexpr double kStopWall_mm = 1.0;     ///< around a pressed stop pin, at least (practice)
inline constexpr double kMotor_mm = 15.0;       ///< of a shaft beyond what holds it, for the motor's coupling
inline constexpr double kShaftEnd_mm = 2.0;     ///< of a shaft beyond the last part on it

inline constexpr double kAnchorHole = 0.75;           ///< radius of a hole for a cable's end, over the cable's diameter
inline constexpr double kDeadWrap = core::kPi / 6.0;  ///< of a drum that always stays wound, so that friction carries the anchor [rad]

/// Radius to which the edges of a guide's hole are rounded by hand: Samson's least bend of a rope, or half of the wall that has the hole.
[[nodiscard]] inline double guide_edge_mm(double cable_mm, double wall_mm) { return std::min(1.5 * cable_mm, 0.5 * wall_mm); }

/// "round the edges of the hole for the cable by hand: R 1.2 mm"; "" of a body without such a hole, or with an idler.
[[nodiscard]] std::string edge_note(const Assembly& assembly, const std::string& body);

/// Holes through the joint's pulley for the output link, evenly about the axis.
struct LinkHoles {
    int count = 0;  ///< 0: no room for M3 between bore and floor
    double circle_mm = 0.0;
};
/// @param hub of the joint's shaft @param floor_mm radius of the pulley's floor
[[nodiscard]] LinkHoles link_holes(const solid::HubOptions& hub, double floor_mm);

/// Sleeve bearing of the spool's axle, in the carriage's plate. @param bore_mm of the axle @returns outside diameter
[[nodiscard]] double sleeve_mm(double bore_mm);
/// Set collar of a shaft: outside diameter and width (DIN 705; between its sizes twice the shaft, and 1.3 times).
struct Collar {
    double outside_mm = 0.0, width_mm = 0.0;
};
[[nodiscard]] Collar collar_of(double shaft_mm);
inline constexpr double kRingHeight_mm = 2.0;  ///< of a retaining ring over its shaft
/// Outside diameter of the support washers between carriage and spool (DIN 988).
[[nodiscard]] double washer_mm(double shaft_mm);
/// Deep-groove ball bearing of a shaft: "ISO 15 626, 6 x 19 x 6 mm", its width, the diameter of its seat, and its static load rating C0
/// (ISO 76) [N]; 0: not known.
[[nodiscard]] std::string bearing_of(double bore_mm);
[[nodiscard]] double bearing_rating(double bore_mm);
/// The least bore whose bearing has at least this rating [N].
[[nodiscard]] std::optional<double> bore_of_rating(double rating);
[[nodiscard]] double bearing_width_mm(double bore_mm);
[[nodiscard]] double bearing_seat_mm(double bore_mm);
/// Retaining ring of a shaft: thickness (DIN 471).
[[nodiscard]] double ring_mm(double shaft_mm);
/// The longest parallel pin of ISO 2338 on sale up to a length, else the shortest [mm].
[[nodiscard]] int pin_length_mm(double most_mm);
/// That pin as a bill names it: "ISO 2338, 2 x 4 mm".
[[nodiscard]] std::string pin_of(double diameter_mm, double most_mm);

/// Radius of a drum's flange: the lips of its groove stand a cable over the cable.
[[nodiscard]] inline double flange_mm(double radius_mm, double cable_mm) { return radius_mm + 1.5 * cable_mm; }
[[nodiscard]] double outer_mm(const spring::BaseSpring& spring);  ///< radius; 0: not stated
[[nodiscard]] double inner_mm(const spring::BaseSpring& spring);
/// Length of a torsion spring's body wound to `state`; 0: not stated.
[[nodiscard]] double wound_length_mm(const spring::BaseSpring& spring, double state);
/// State in which the spring behind this spool is wound most [rad].
[[nodiscard]] double most_wound(const spring::BaseSpring& spring, const solid::Part& spool);
/// Does the spool's axle go through it, with the spring around it?
[[nodiscard]] bool has_through_axle(const solid::Part& spool);
/// Diameter of what stands inside the torsion spring: as stated, else a through axle; 0: nothing.
[[nodiscard]] double arbor_mm(const Drive& drive);
/// Does an arm of the carriage hold that arbor from above? The axle of an overhung spool ends below the spring.
[[nodiscard]] bool has_bridge(const Drive& drive);
/// How far the radial leg reaches from the axis: beyond its post by its own thickness.
[[nodiscard]] double leg_end_mm(double leg_post_mm, const spring::BaseSpring& spring);
/// Where about K_SE's axis the radial leg stands at rest, from +x [rad]: the axial leg in its slot, the stated coils and the preload
/// decide. Nothing where coils or slot are not stated. @param k_se placement of the part
[[nodiscard]] std::optional<double> leg_angle(const Drive& drive, const Eigen::Isometry3d& k_se);
/// What stands up from the carriage's base for the spring: the post without its slot and, of an overhung spool, the column of its bridge.
[[nodiscard]] std::vector<Extrusion> leg_posts(const Layout& layout, const Drive& drive);
/// The place of the post: that of the leg or, where the series cable passes, the nearest free one [rad]. @pre K_SE is placed
[[nodiscard]] double post_angle(const Layout& layout, const Drive& drive);
/// How far the post reaches to the rear of K_SE's axis.
[[nodiscard]] double post_rear_mm(const Layout& layout, const Drive& drive);
/// Turns a shape about the z axis of its body [rad].
void turn_about_axis(Extrusion& shape, double angle);
/// A shaft at its bearing, over the working range: bending and torsion [Nm] where the stress is largest.
struct ShaftLoad {
    double diameter = 0.0;  ///< [m]
    bool keyed = false;
    double moment = 0.0, torque = 0.0;
    double stress_MPa = 0.0;  ///< shear, 16 sqrt((1.5 M)^2 + T^2)/(pi d^3)
};
/// The motor's shaft holds K_PE beyond its nearest bearing, which is taken to stand between K_PE and the capstan. Without room for it there
/// it is behind the capstan's collar, and the pulls of both cables add as vectors.
[[nodiscard]] ShaftLoad motor_shaft_load(const Assembly& assembly);
/// The spool's axle above its sleeve.
[[nodiscard]] ShaftLoad axle_load(const Assembly& assembly);
/// Least and largest tension of a cam's cable over its working range [N].
[[nodiscard]] std::array<double, 2> tensions(const cam::Cam& cam);
/// Middle height of a bearing of the frame, in the order of its body: tower, plate at the joint, then arm and plate of each motor.
/// @pre there is a frame
[[nodiscard]] double bearing_mm(const Assembly& assembly, std::size_t bearing);
/// The joint's shaft at the tower's bearing: both series cables pull at its pulley.
[[nodiscard]] ShaftLoad joint_shaft_load(const Assembly& assembly);
/// What the cables do to the frame, over the working range (docs/assembly.md). The output link's own load is not known.
struct FrameLoad {
    struct Bearing {
        const char* of;
        double force = 0.0;  ///< across its axis [N]
    };
    struct Part {
        const char* name;
        double stress_MPa = 0.0;  ///< where it bends most
        double screw = 0.0;       ///< largest pull at one of its screws in the plate [N]; 0: it has none, or they carry no moment
        checks::Material material = {};
    };
    std::array<Bearing, 4> bearings{{{"a motor's shaft, in frame_rear"},
                                     {"a motor's shaft, in frame_plate"},
                                     {"the joint's shaft, in joint_tower"},
                                     {"the joint's shaft, in frame_plate"}}};
    std::array<Part, 5> parts{{{"arms of frame_rear"}, {"frame_rear"}, {"joint_tower"}, {"k_pe_posts"}, {"frame_plate"}}};
};
/// Nothing without a frame.
[[nodiscard]] std::optional<FrameLoad> frame_load(const Assembly& assembly);
/// Thickness of the frame's plate, and its width across x at a height y, less its holes there. @pre there is a frame
[[nodiscard]] double plate_mm(const Assembly& assembly);
[[nodiscard]] double plate_width_mm(const Assembly& assembly, double y_mm);
/// Width of frame_rear that bends on one side of the joint, under a load on its arm so deep below the plate: spread at 45 deg, less holes.
[[nodiscard]] double rear_width_mm(const Assembly& assembly, double depth_mm);
/// How far frame and shafts follow the cables of one kind, both sides pulled alike, and how stiff the springs behind these cables are.
struct FrameGive {
    const char* cables;
    double plate = 0.0, whole = 0.0;  ///< of a cable per newton of its tension [m/N]: by the bent plate alone, and all
    double rate = 0.0;                ///< of the springs at the cable, where they are stiffest [N/m]
};
/// Of the series cables and, where the frame has posts, of the parallel ones. @pre there is a frame
[[nodiscard]] std::vector<FrameGive> frame_gives(const Assembly& assembly);
/// Of the strongest usual shaft steel [MPa].
[[nodiscard]] double allowed_shaft_stress_MPa(bool keyed);
/// The least of the usual shaft steels that bears the load, else the strongest.
[[nodiscard]] const char* shaft_steel(const ShaftLoad& load);
/// Height of the carriage's walls over the cables.
[[nodiscard]] inline double wall_height_mm(double cable_mm) { return std::max(3.0, 3.0 * cable_mm); }

/// From `low` to `high`, over all its length along y, with round holes along y: their x_mm is x, their y_mm is z.
[[nodiscard]] Extrusion block(const Eigen::Vector3d& low, const Eigen::Vector3d& high, std::vector<RoundHole> holes);
/// A bought body, and one that the workshop makes.
[[nodiscard]] Body shaped(std::string name, Motion motion, const Eigen::Isometry3d& rest, std::vector<Extrusion> shapes);
[[nodiscard]] Body to_make(std::string name, Motion motion, const Eigen::Isometry3d& rest, std::vector<Extrusion> shapes);
/// A shaft whose length from `flat_low` to `flat_high` has the flat of the hub, if it asks for one; else round all along.
[[nodiscard]] std::vector<Extrusion> shaft_with_flat(const solid::HubOptions& hub, double lock_angle, double low, double high,
                                                     double flat_low, double flat_high);
/// x of the rods about K_SE's axis, to both sides; their height over the side's cables.
[[nodiscard]] inline double rod_aside_mm(const Layout& l) { return l.carriage_half - kHousing_mm; }
[[nodiscard]] inline double rod_height_mm(const Layout& l) { return l.carriage_low + kHousing_mm; }
/// Half the width of the seat of K_PE's spring, and how far its screws are from the middle, in x and in z.
[[nodiscard]] double seat_half_mm(const Drive& drive);
[[nodiscard]] double seat_screw_mm(const Drive& drive);

/// Depth of such a post along the cable.
inline constexpr double kPost_mm = 24.0;

// The frame (frame.cpp): a plate above all else on the motors' side, brackets below it that hold the rods, the motor shafts' inner bearings
// and the seats, and a tower with the joint's bearing and stops.
inline constexpr double kPlate_mm = 10.0;       ///< thickness of the plate, at least: the cables bend it (joint.frame_stiffness)
inline constexpr double kBracket_mm = 16.0;     ///< of the brackets along y: the motors' cables bend the rear one (joint.frame_stiffness)
inline constexpr double kRodScrew_mm = 4.5;     ///< space for a rod's washer and screw beyond a bracket: heads of M3 are 3 mm high
inline constexpr double kThread_mm = 14.0;      ///< depth of the threads for the plate's screws
inline constexpr double kScrewReach_mm = 9.0;   ///< of these screws in their threads, at least
inline constexpr double kCoreHole_mm = 1.25;    ///< radius before an M3 thread is cut
inline constexpr double kBearingWall_mm = 4.0;  ///< around a bearing's seat
inline constexpr double kPassHole = 1.5;        ///< radius of a hole that a cable passes without touching it, over the cable's diameter
/// Thickness of the plate: at least as wide as its bearings. @param shaft_mm diameter
[[nodiscard]] double frame_plate_mm(const Layout& layout, double shaft_mm);
/// Radius of the tower around the joint's shaft. @param shaft_mm diameter
[[nodiscard]] double tower_mm(const Layout& layout, double shaft_mm);
/// Feet of the joint's stop posts over the joint's middle plane: half a gap and a knot above the pulley, then the pin's overlap.
[[nodiscard]] double stop_foot_mm(const Layout& layout);
/// What stops a capstan beyond both ends of its range: a pin pressed into its lower flange and floor, which meets posts pressed into the
/// arm of frame_rear. Heights over the side's cables, angles about the motor's axis at rest, of the agonist.
struct CapstanStops {
    double circle_mm = 0.0;     ///< radius on which pin and posts stand
    double pin = 0.0;           ///< [rad]
    std::vector<double> posts;  ///< one or two [rad]
    double pin_low_mm = 0.0, pin_high_mm = 0.0, post_high_mm = 0.0;
};
/// Nothing without a frame, where the capstan has no room beside its bore or the arm's bearing, or where it turns nearly a whole turn.
[[nodiscard]] std::optional<CapstanStops> capstan_stops(const Layout& layout, const solid::HubOptions& hub);
/// Angles of the posts for a pin that may turn by `range`, from the middle of that [rad]: two, or one opposite where two would meet.
[[nodiscard]] std::vector<double> post_angles(double circle_mm, double range);
/// The pin as "capstan_pin" and the posts as "capstan_stops", where there are any.
void add_capstan_stops(const Layout& layout, const solid::HubOptions& hub, std::vector<Body>& to);
/// Nothing without a frame. Bodies of both sides in the assembly's frame, and the holes of the plate.
[[nodiscard]] std::vector<Body> frame_bodies(const Layout& layout, const Drive& drive, double joint_range, std::vector<FrameHole>& holes);
/// Places of the stop posts about the joint's axis: two, or one where the joint turns so far that they would meet.
[[nodiscard]] std::vector<Eigen::Vector2d> stop_places(const Layout& layout, double joint_range);

/// Lines of the bill: torsion and compression springs.
[[nodiscard]] std::array<BillRow, 2> spring_rows(const Assembly& assembly);

/// The hub as its shaft has it: a set screw presses on a flat.
[[nodiscard]] inline solid::HubOptions on_shaft(solid::HubOptions hub) {
    if (hub.lock == solid::HubLock::kSetScrew) hub.lock = solid::HubLock::kDFlat;
    return hub;
}
/// Capstan and joint's pulley are locked by what the motor's shaft has for K_PE: keyway or flat. Round without a lock's shape where less
/// than 1 mm would be left to the floor. @param floor_mm radius of the drum's floor
[[nodiscard]] solid::Outline drum_bore(const solid::HubOptions& hub, double floor_mm);
[[nodiscard]] bool drum_has_lock(const solid::HubOptions& hub, double floor_mm);

[[nodiscard]] Layout lay_out(const Drive& drive, double capstan_radius, double joint_radius, const AssemblyOptions& options,
                             double greatest_turn);

/// The bodies of the agonist's side, at rest.
[[nodiscard]] std::vector<Body> side_bodies(const Layout& layout, const Drive& drive);
/// Its bore is the capstan's. The agonist's cable leaves it at 0 deg and is wound counter-clockwise; its end is in the upper flange, the
/// antagonist's in the lower one. @param joint_range [rad]
[[nodiscard]] Body joint_pulley(const Layout& layout, const solid::HubOptions& hub, double joint_range);
/// The pin that stops the pulley at its posts: a bought one in a hole through flange and floor of one groove. Nothing where the pulley is
/// too small for the hole: then the pin is part of it.
[[nodiscard]] std::optional<Body> stop_pin(const Layout& layout);
/// Two posts of the frame beside the pulley, above with a frame, which its pin meets at both ends of the joint's range [rad].
[[nodiscard]] Body joint_stops(const Layout& layout, double joint_range);
/// A body of the agonist as the antagonist's.
[[nodiscard]] Body mirrored(const Body& body);

}  // namespace fusee::assembly
