#pragma once
#include <optional>
#include <vector>

#include "fusee/actuator/stick_slip.h"
#include "fusee/core/finding.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/simulation.h"
#include "fusee/profile/profile.h"
#include "fusee/spring/friction.h"

/// Example:
/// @code
/// const profile::Profile p = profile::read_profile("profiles/pnrvsa.toml");
/// const auto joint = pipeline::simulate(p, {.levels = 5, .at = {{1.0, 0.9, 0.0}}});
/// if (!joint) return joint.refusal();  // the law's
/// for (const pipeline::SimulatedLevel& level : joint->levels)
///     std::cout << level.dead_band.tau << ' ' << level.dead_band.exact_width << '\n';  // [Nm], full width at the joint [rad]
/// @endcode
namespace fusee::pipeline {

struct SimulateOptions {
    int levels = 0;                          ///< of co-contraction; 0: as the profile says
    std::optional<double> push_torque = {};  ///< of the push-and-release test [Nm]; none: as the profile says
    std::vector<Eigen::Vector3d> at = {};    ///< torques (tau_1, tau_2, tau_q) at which the equilibrium is asked for [Nm]
};

/// The joint at rest and pushed, with its motor and frame subsystems and its noise; for the paper's relatives the comparison only. Needs no
/// parts. An equilibrium that does not exist says why in its row.
[[nodiscard]] Simulation simulate(const ResolvedDesign& design, const SimulateOptions& options = {});
/// Refusal: the law's. @throws core::InvalidInput
[[nodiscard]] core::Outcome<Simulation> simulate(const profile::Profile& profile, const SimulateOptions& options = {});

/// Simulates only what `headline_of` reads: `survey`, `condition` and the findings. @pre the design has the paper's arrangement
[[nodiscard]] Simulation headline_simulation(const ResolvedDesign& design);

/// The design's joint with its bearing.
[[nodiscard]] actuator::Joint joint_of(const ResolvedDesign& design);
/// The same with each spring tabulated once (spring::resampled), for paths of thousands of steps; the gears without friction if `gears` is
/// false (paper: the frame subsystem).
[[nodiscard]] actuator::Joint path_joint_of(const ResolvedDesign& design, bool gears = true);

/// Equilibrium (1), sensitivity (2) and dead-band under three torques, or the refusal.
/// @throws core::InvalidInput if a torque is not finite
[[nodiscard]] EquilibriumRow equilibrium_at(const actuator::Joint& joint, const Eigen::Vector3d& torque);

/// All three dead-bands at one co-contraction. @param joint the actuator's, with its bearing
[[nodiscard]] SimulatedLevel simulate_level(const actuator::Actuator& actuator, const actuator::Joint& joint, double tau,
                                            const actuator::ReleaseTest& test = {});

/// The path of a push-and-release test with `push_torque` [Nm], both ways.
[[nodiscard]] ReleasePath release_path(const actuator::Joint& joint, double tau, double push_torque);
/// The joint torque cycled between +-`torque` [Nm] until the path repeats.
[[nodiscard]] DeflectionLoop deflection_loop(const actuator::Joint& joint, double tau, double torque);
/// The loop of each cable on its cam under friction; empty if the profile has no parts, or no friction and stiffness of its cable.
[[nodiscard]] std::vector<WrapSide> wrap_sides(const ResolvedDesign& design);
/// The part of the capstan's travel that each cable's stretch takes; empty if the profile has no parts, or no cable that stretches.
[[nodiscard]] std::vector<StretchSide> stretch_sides(const ResolvedDesign& design);
/// Figure 8 for `count` motor torques from 0 to `greatest`.
[[nodiscard]] std::vector<BreakAwayRow> break_away_rows(const spring::FrictionLaw& gear, double greatest, std::size_t count);

}  // namespace fusee::pipeline
