#pragma once
#include <array>
#include <vector>

#include "fusee/assembly/assembly.h"

/// Kinematics of an assembly. All zero: both capstans at their laws' lowest load, the joint in its middle.
namespace fusee::assembly {

/// One side: a positive turn of the capstan loads both of its springs.
struct SidePose {
    double turn = 0.0;       ///< of the capstan [rad], 0 to Assembly::greatest_turn
    double payout_mm = 0.0;  ///< of K_SE, 0 to Assembly::greatest_payout_mm
};

struct Pose {
    SidePose agonist, antagonist;
    [[nodiscard]] const SidePose& of(Side side) const { return side == Side::kAntagonist ? antagonist : agonist; }
};

/// The pose of two capstans and the joint, whose positive angle winds the agonist's cable: payout = r_c turn + r_j joint for the agonist, -
/// for the antagonist.
[[nodiscard]] Pose pose_of(const Assembly& assembly, double agonist_turn, double antagonist_turn, double joint);
/// The angle to each side that the joint reaches at this turn of both capstans [rad]: beyond, a K_SE would leave its range.
[[nodiscard]] double greatest_joint_angle(const Assembly& assembly, double turn);
/// The joint's angle of a pose [rad].
[[nodiscard]] double joint_angle(const Assembly& assembly, const Pose& pose);

/// Angle of the spool for a payout [rad].
[[nodiscard]] double spool_angle(const Assembly& assembly, double payout_mm);
/// Cable that K_PE has drawn in [mm].
[[nodiscard]] double drawn_mm(const Assembly& assembly, double turn);

/// Leads from the body's own frame to the assembly's, in a pose.
[[nodiscard]] Eigen::Isometry3d placement(const Assembly& assembly, const Body& body, const Pose& pose);

/// A body's mesh in the assembly's frame, in a pose.
[[nodiscard]] solid::Mesh placed_mesh(const Assembly& assembly, const Body& body, const Pose& pose);

/// The straight free lengths of a cable in a pose, from end to end.
struct FreeCable {
    CableKind kind = CableKind::kDrive;
    Side side = Side::kAgonist;
    Eigen::Vector3d from_mm, to_mm;
};
[[nodiscard]] std::vector<FreeCable> free_cables(const Assembly& assembly, const Pose& pose);

}  // namespace fusee::assembly
