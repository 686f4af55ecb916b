#pragma once
#include <optional>
#include <string>

#include "fusee/checks/check.h"
#include "fusee/profile/profile.h"

/// A first profile from a few answers (docs/guides/init.md).
namespace fusee::init {

/// What a person knows of a joint before its first cams. Torques of one motor, full values; SI.
struct Answers {
    double torque = 1.0;                    ///< of one motor at the joint, held for long [Nm]
    double overdrive = 0.0;                 ///< the same for a short time [Nm]; 0: 1.5 times `torque`
    double least = 0.0;                     ///< least co-contraction used, at the joint [Nm]; 0: 0.85 times `torque`
    double ratio = 1.0;                     ///< r_j/r_c: turns of a capstan for one turn of the joint
    double joint_range = 0.0;               ///< between the joint's stops [rad]; 0: what the springs allow
    std::optional<profile::TablePair> law;  ///< measured springs at the capstan, the loading branch; none: a law of the paper's kind
    core::CsvMapping columns;               ///< of the files of measured springs and of break-away tests
    double joint_stiffness = 0.0;           ///< capstans held, at `torque` of co-contraction [Nm/rad]; 0: chosen
    double friction = 0.28;                 ///< gear friction over the load on the capstan
    double friction_constant = 0.0;         ///< its part that does not depend on the load [Nm]
    std::string construction = "fibre";
    double cable = 0.8e-3;       ///< diameter [m]
    double breaking_load = 0.0;  ///< [N]; 0: that of a usual cable of this construction and diameter
    double shaft = 6e-3;         ///< diameter [m]
    checks::ProcessKind process = checks::ProcessKind::kFdm;
    std::string material = checks::kByProcess;
    double bed = 0.2;  ///< side of the machine's bed or of the stock [m]

    /// Torques at the capstan [Nm], defaults filled in.
    [[nodiscard]] double peak_torque() const { return torque / ratio; }
    [[nodiscard]] double overdrive_torque() const { return (overdrive > 0.0 ? overdrive : 1.5 * torque) / ratio; }
    [[nodiscard]] double least_torque() const { return (least > 0.0 ? least : 0.85 * torque) / ratio; }
};

/// @throws core::InvalidInput naming the option, if two answers exclude each other: an overdrive torque below the torque, a torque beyond
/// the measured law
void require_consistent(const Answers& answers);

}  // namespace fusee::init
