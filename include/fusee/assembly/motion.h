#pragma once
#include <array>
#include <string>
#include <vector>

#include "fusee/assembly/assembly.h"

/// Kinematics of an assembly, and the order in which it is put together. All zero: both capstans at their laws' lowest load, the joint in
/// its middle.
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

/// A body by its name without the side, or one of its shapes.
struct Piece {
    std::string body;  ///< "k_se": of each side, one after the other
    int shape = -1;    ///< -1: all
};

/// One step by which the joint is put together: bodies that come along a straight path to their places in the pose of zero.
struct Step {
    std::string subassembly;  ///< the subassembly that it adds to, by its first body; "": the joint
    std::vector<Piece> pieces;
    Eigen::Vector3d along = Eigen::Vector3d::Zero();  ///< of the motion; zero: what the others are put on
    std::string how;                                  ///< a remark for the workshop; may be empty
};

/// The order in which a joint with a frame is put together; every body has a step. Empty without a frame, and where an arm of the carriage
/// stands over the torsion spring.
[[nodiscard]] std::vector<Step> assembly_steps(const Assembly& assembly);

}  // namespace fusee::assembly
