#pragma once
#include <array>
#include <vector>

#include "fusee/actuator/joint.h"

namespace fusee::actuator {

/// The dead-band at one level of equal co-contraction: full width (edge to edge) at the joint. Figures outside the law are NaN.
struct DeadBand {
    double tau = 0.0;                   ///< motor torque of both sides, at the capstan [Nm]
    double linear = 0.0;                ///< 2 tau_f(tau)/(g P): paper (3)-(4) for a symmetric actuator [rad]
    double exact_width = 0.0;           ///< the widest pair of resting places with capstan loads anywhere in resting_loads(tau) [rad]
    bool covered = true;                ///< false: the springs do not cover the loads that stiction allows at this torque
    double joint_stiffness = 0.0;       ///< dtau_q/dq with both capstans held by stiction: 2 g^2 S [Nm/rad]
    double free_joint_stiffness = 0.0;  ///< with both capstans free: 2 g^2 S P/(S+P) [Nm/rad]
    double theta = 0.0;                 ///< capstan angle [rad]
    double condition_6 = 0.0;           ///< d(T tau_f)/dtau; below 0: co-contraction shrinks the transmitted stiction (paper (6))
};

/// @param tau motor torque [Nm]. The linear figure needs tau inside the law's loads (NaN outside).
[[nodiscard]] DeadBand dead_band(const Actuator& actuator, double tau);
/// `count` levels from least to overdrive torque, evenly spaced. @throws InvalidInput if count < 2
[[nodiscard]] std::vector<DeadBand> dead_band_curve(const Actuator& actuator, std::size_t count);

/// Where the paper's condition (6) holds, among the co-contractions from least to overdrive torque that the law covers.
struct ConditionSummary {
    core::Range torques;             ///< examined [Nm]; width below 0: the law covers none of them
    std::vector<core::Range> holds;  ///< the ranges, ascending, where d(T tau_f)/dtau < 0 [Nm]
    core::Range values;              ///< least and greatest d(T tau_f)/dtau found; NaN: none
    [[nodiscard]] bool everywhere() const { return values.high < 0.0; }
    [[nodiscard]] bool nowhere() const { return holds.empty(); }
};
[[nodiscard]] ConditionSummary summarize_condition(const Actuator& actuator);

/// The dead-band of any joint at any two motor torques, as DeadBand: full width at the output. Figures outside the laws are NaN.
struct JointDeadBand {
    Eigen::Vector3d z = Eigen::Vector3d::Zero();  ///< resting place without friction [rad]
    double linear = 0.0;                          ///< paper (3)-(4), edge to edge: sum of |dq/dtau_i| 2 tau_f,i(tau_i) [rad]
    double exact_width = 0.0;                     ///< between `edges` [rad]
    core::Range edges;                            ///< least and greatest q with capstan loads anywhere in their resting_loads [rad]
    bool covered = true;                          ///< false: no resting place, or an edge, lies within the springs' laws
    std::array<double, 2> condition_5{};          ///< d(T_i tau_f,i)/dtau_i, one torque raised: the paper's (5)
    std::array<double, 2> condition_6{};          ///< d(T_i tau_f,i)/dtau, both torques raised equally
    double joint_stiffness = 0.0;                 ///< both capstans held [Nm/rad]
    double free_joint_stiffness = 0.0;            ///< both capstans free [Nm/rad]
};
/// q falls with the load of capstan 1 and rises with that of capstan 2 (in other networks: by the sensitivity at z), so that its
/// extremes lie at corners of the loads.
/// @throws InvalidInput if a torque is not finite
[[nodiscard]] JointDeadBand joint_dead_band(const Joint& joint, double tau_1, double tau_2);

}  // namespace fusee::actuator
