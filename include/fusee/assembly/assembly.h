#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fusee/assembly/options.h"
#include "fusee/cam/arm.h"
#include "fusee/checks/check.h"
#include "fusee/core/finding.h"
#include "fusee/core/units.h"
#include "fusee/solid/extrusion.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/part.h"
#include "fusee/spring/base_spring.h"

/// Bodies that fusee does not make, as simple shapes: drums, shafts, plates, springs.
/// Where every part of the joint stands and how it moves (docs/assembly.md).
///
/// Frame of the assembly: +z along the joint's axis, origin on it half-way between the planes of the two sides' cables; the motors are at
/// -y, the agonist at +x. Lengths in mm. The antagonist's side is the mirror image x -> -x.
///
/// Each K_SE turns on a carriage, which its capstan pulls along y; the torsion spring reacts against the carriage, so that the arm depends
/// on the cable's payout alone. Each K_PE turns with its capstan and pulls a compression spring through a plate on which that spring
/// stands.
namespace fusee::assembly {

using solid::Extrusion, solid::RoundHole;

/// About the z axis of the body, from `z_low` to `z_high`. @param bore_radius_mm 0: none
[[nodiscard]] Extrusion round(double radius_mm, double z_low_mm, double z_high_mm, double bore_radius_mm = 0.0);
/// Along `axis` of the body's frame from `from_mm`. @param bore_radius_mm 0: none
[[nodiscard]] Extrusion rod(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& axis, double radius_mm, double length_mm,
                            double bore_radius_mm = 0.0);
/// A box of the body's frame, with holes along z.
[[nodiscard]] Extrusion box(const Eigen::Vector3d& low_mm, const Eigen::Vector3d& high_mm, std::vector<RoundHole> holes = {});

/// Meshes a shape in the frame of its body, closed and facing outward; circles are within 0.02 mm.
[[nodiscard]] solid::Mesh mesh_of(const Extrusion& shape);
/// Gives a mesh in another frame.
[[nodiscard]] solid::Mesh moved(solid::Mesh mesh, const Eigen::Isometry3d& placement);
/// The mirror image of a body in its plane x = 0: shape(p) for p with -x.
[[nodiscard]] Extrusion mirrored(const Extrusion& shape);

/// A body's hull between two heights, for distances: convex.
struct Prism {
    solid::Ring outline_mm;
    double z_low_mm = 0.0, z_high_mm = 0.0;
};
/// A shape placed in the assembly: for shapes along z, round ones as a polygon around them; a box of heights for others.
[[nodiscard]] Prism prism_of(const Extrusion& shape, const Eigen::Isometry3d& placement);
/// A cam as hulls of horizontal layers, larger than it by at most 0.3 % of its radius. @param z_levels_mm heights in the mesh's frame,
/// rising
[[nodiscard]] std::vector<Prism> layers_of(const solid::Mesh& mesh, const std::vector<double>& z_levels_mm);
/// @pre the placement turns z to +z or -z
[[nodiscard]] Prism placed(const Prism& prism, const Eigen::Isometry3d& placement);

/// The disc about the z axis that holds a prism in every turn, as a polygon around it.
[[nodiscard]] Prism disc_around(const Prism& prism);
/// The hull of a prism shifted by `from_mm` and by `to_mm`, both along the plane: all that it passes between them.
[[nodiscard]] Prism hull_between(const Prism& prism, const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm);

/// Distance of two prisms, 0 if they meet, or `most_mm` if it is that much or more.
[[nodiscard]] double distance_mm(const Prism& a, const Prism& b, double most_mm);
/// The same of a straight cable and a prism.
[[nodiscard]] double distance_mm(const Eigen::Vector3d& from_mm, const Eigen::Vector3d& to_mm, const Prism& prism, double most_mm);

/// What a body moves with.
enum class Motion {
    kFixed,
    kCapstan,    ///< turns with the capstan
    kCarriage,   ///< slides with the cable of the capstan
    kSpool,      ///< turns on the carriage
    kSpringEnd,  ///< slides with the end of K_PE's cable
    kJoint,      ///< turns with the joint
};
[[nodiscard]] const char* to_string(Motion motion);

enum class Side { kAgonist, kAntagonist, kBoth };
[[nodiscard]] const char* to_string(Side side);  ///< "agonist", "antagonist", "joint"

struct Body {
    std::string name;  ///< "k_se_agonist", "capstan_antagonist", "joint_pulley"
    Side side = Side::kBoth;
    Motion motion = Motion::kFixed;
    Eigen::Isometry3d rest = Eigen::Isometry3d::Identity();  ///< from its own frame to the assembly, in the pose of zero
    std::vector<Extrusion> shapes;                           ///< touching; none: a cam
    std::shared_ptr<const solid::Mesh> cam;                  ///< null: `shapes`
    std::vector<Prism> prisms;                               ///< in its own frame; for distances
    bool made = false;                                       ///< by the workshop from a file of its own; else bought, or a cam
    [[nodiscard]] std::string base_name() const;             ///< without the side: "k_se"
    [[nodiscard]] solid::Mesh mesh() const;                  ///< in its own frame; several shells where it has several shapes
};

/// Red, green and blue (sRGB) in which files and pictures show a body.
[[nodiscard]] std::array<std::uint8_t, 3> colour_of(const Body& body);

/// Free length of a cable, and what it is attached to.
enum class CableKind {
    kDrive,     ///< capstan to carriage
    kSeries,    ///< K_SE to the joint's pulley
    kParallel,  ///< K_PE to the end of its spring
};
[[nodiscard]] const char* to_string(CableKind kind);

/// One cable with its length between the anchors, without the ends for knots.
struct Cable {
    CableKind kind = CableKind::kDrive;
    Side side = Side::kAgonist;
    double length_mm = 0.0;
    std::string from, to;  ///< names of bodies
    /// The length to cut the cable to, with both its ends, in whole millimetres.
    [[nodiscard]] double cut_mm() const;
};

/// Length that each end of a cable needs for its termination [mm] (practice).
inline constexpr double kCableEnd_mm = 30.0;

/// What one side consists of, as designed for the agonist.
struct Drive {
    std::shared_ptr<const solid::Part> k_se, k_pe;
    spring::BaseSpring k_se_spring, k_pe_spring;
    checks::Cable cable;  ///< of all its cables
    checks::Process process = {};
    /// The agonist's K_PE is the mirror image of the designed one, which is the antagonist's: an overhung one hangs below its capstan so.
    bool k_pe_mirrored = false;
};

/// One place on a cam's table: angle since the lowest load, cable paid out or drawn in since then.
struct Travel {
    double angle = 0.0;      ///< [rad]
    double length_mm = 0.0;  ///< integral of the arm over the angle
};

/// The slot of the carriage's post, in which the torsion spring's radial leg lies. Heights are over the side's cables.
struct LegSlot {
    double width_mm = 0.0;  ///< 0: the spring is not stated
    double floor_mm = 0.0, top_mm = 0.0;
    double near_mm = 0.0, far_mm = 0.0;  ///< from K_SE's axis, along the leg
};

/// A round hole through the frame's plate, in the assembly's frame.
struct FrameHole {
    double x_mm = 0.0, y_mm = 0.0, diameter_mm = 0.0;
    std::string holds;  ///< "bearing of the joint", "screw of frame_rear"
};

/// The joint with all bodies at rest and the figures of its motion. Immutable.
struct Assembly {
    Drive drive;
    AssemblyOptions options;
    double capstan_radius_mm = 0.0, joint_radius_mm = 0.0, cable_mm = 0.0;
    double motor_distance_mm = 0.0;
    double carriage_rear_mm = 0.0;  ///< from K_SE's axis to the wall that the drive cable pulls
    double leg_post_mm = 0.0;       ///< from K_SE's axis to that of the post that holds its spring's leg
    double leg_post_angle = 0.0;    ///< of that post about K_SE's axis, from +x, agonist [rad]
    LegSlot leg_slot;               ///< of that post
    double spring_low_mm = 0.0;     ///< height of the torsion spring's lower end over its side's cables
    double plane_mm = 0.0;          ///< height of the agonist's cables; the antagonist's are at its negative
    double greatest_turn = 0.0;     ///< of a capstan from the law's lowest load: the working range of K_PE [rad]
    double spare_turn = 0.0;        ///< of a capstan beyond both ends of that, to its stops [rad]
    double greatest_payout_mm = 0;  ///< of K_SE: its working range
    double joint_range = 0.0;       ///< full, symmetric about the joint's middle [rad]
    std::vector<Travel> k_se, k_pe;
    Eigen::Vector3d spool_axis_mm = Eigen::Vector3d::Zero();  ///< of the agonist at rest, at its cables' height
    Eigen::Vector3d motor_axis_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d k_se_guide_mm = Eigen::Vector3d::Zero(), k_pe_guide_mm = Eigen::Vector3d::Zero();  ///< holes at rest
    std::vector<Body> bodies;
    std::vector<Cable> cables;
    std::vector<FrameHole> frame_holes;  ///< empty: no frame
    core::Findings notes;                ///< what the model leaves out for want of data

    [[nodiscard]] const Body* find(const std::string& name) const;
};

/// Refusal "joint.guide": a guide that is a direction without a place, and "joint.roller": a cam with a roller has no cable.
[[nodiscard]] core::Outcome<Assembly> assemble(Drive drive, double capstan_radius, double joint_radius, const AssemblyOptions& options);

/// One line of the bill of materials: all equal pieces of both sides.
struct BillRow {
    std::string item;  ///< "k_se", "torsion spring", "series cable"
    int count = 1;
    std::string size;  ///< with units; a catalogue's designation where there is one
    std::string note;  ///< file, place or what is not stated
};

/// What the joint consists of, both sides: parts, frame, springs, cables cut to length, shafts, keys, bearings, bushes. The motors are not
/// in it.
[[nodiscard]] std::vector<BillRow> bill_of(const Assembly& assembly);

}  // namespace fusee::assembly
