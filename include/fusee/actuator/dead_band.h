#pragma once
#include <vector>

#include "fusee/actuator/actuator.h"

namespace fusee::actuator {

/// The dead-band at one level of equal co-contraction: full width (edge to edge) at the joint.
struct DeadBand {
    double tau = 0.0;     ///< motor torque of both sides, at the capstan [Nm]
    double linear = 0.0;  ///< 2 mu tau / (g P): paper (3)-(4) for a symmetric actuator [rad]
    double extreme =
        0.0;  ///< the widest pair of resting places with capstan loads anywhere in [tau/(1+mu), tau/(1-mu)] [rad]; NaN if not covered
    bool covered = true;                ///< false: the springs do not cover the loads that stiction allows at this torque
    double joint_stiffness = 0.0;       ///< dtau_q/dq with both capstans held by stiction: 2 g^2 S [Nm/rad]
    double free_joint_stiffness = 0.0;  ///< with both capstans free: 2 g^2 S P/(S+P) [Nm/rad]
    double theta = 0.0;                 ///< capstan angle [rad]
    double condition_6 = 0.0;           ///< d(T tau_f)/dtau; below 0: co-contraction shrinks the dead-band (paper (6))
};

/// @param tau motor torque [Nm]. The linear figure needs tau inside the law's loads (NaN outside).
[[nodiscard]] DeadBand dead_band(const Actuator& actuator, double tau);
/// `count` levels from least to overdrive torque, evenly spaced.
[[nodiscard]] std::vector<DeadBand> dead_band_curve(const Actuator& actuator, std::size_t count);

}  // namespace fusee::actuator
