#pragma once
#include <array>
#include <optional>
#include <vector>

#include "fusee/actuator/joint.h"
#include "fusee/assembly/motion.h"

namespace fusee::report {

/// What a pose consists of, in the order of the scene's rows. Angles in rad, lengths in mm.
enum Channel : int {
    kTurnAgonist,
    kSpoolAgonist,
    kCarriageAgonist,
    kDrawnAgonist,
    kTurnAntagonist,
    kSpoolAntagonist,
    kCarriageAntagonist,
    kDrawnAntagonist,
    kJointAngle,
    kChannels
};
using ChannelValues = std::array<double, kChannels>;
[[nodiscard]] ChannelValues channels_of(const assembly::Assembly& assembly, const assembly::Pose& pose);

/// How a body follows the channels: from its own frame to the assembly by rest, turned about its own z by gain * channel, then slid by
/// direction * channel [mm]. The joint's axis is its own z.
struct Follows {
    int turn = -1;  ///< channel; -1: does not turn
    double gain = 0.0;
    int slide = -1;
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
};
[[nodiscard]] Follows follows(const assembly::Assembly& assembly, const assembly::Body& body);
[[nodiscard]] Eigen::Isometry3d placement(const assembly::Body& body, const Follows& follows, const ChannelValues& values);

/// Turns and payouts of a pose, which are smooth in the torques; the other channels follow by the cams' tables of travel.
using PoseValues = std::array<double, 4>;  ///< agonist's turn [rad] and payout [mm], antagonist's
[[nodiscard]] PoseValues values_of(const assembly::Pose& pose);
[[nodiscard]] assembly::Pose pose_from(const PoseValues& values);

/// Poses of the frictionless joint at rest over co-contraction and joint torque; the page interpolates their values linearly.
struct PoseGrid {
    std::vector<double> tau;                    ///< of both motors, rising [Nm]
    std::vector<double> share;                  ///< of `most`, -1 to 1
    std::vector<double> most;                   ///< for each tau: the greatest joint torque within the working range [Nm]
    std::vector<std::vector<PoseValues>> rows;  ///< rows[tau][share]
    double error_rad = 0.0, error_mm = 0.0;     ///< largest error of a channel by the interpolation, at the middle of each cell
};
/// @returns none where no co-contraction of the actuator has a pose within the assembly's working range
[[nodiscard]] std::optional<PoseGrid> pose_grid(const assembly::Assembly& assembly, const actuator::Actuator& actuator);

/// The pose at rest under these torques; none outside the springs' laws or the assembly's working range.
[[nodiscard]] std::optional<assembly::Pose> resting_pose(const assembly::Assembly& assembly, const actuator::Actuator& actuator, double tau,
                                                         double joint_torque);

}  // namespace fusee::report
