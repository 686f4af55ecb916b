#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "fusee/actuator/stick_slip.h"
#include "fusee/core/finding.h"
#include "fusee/friction/law.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"
#include "fusee/report/report.h"
#include "fusee/report/simulation.h"

namespace fusee::pipeline {

struct SimulateOptions {
    int levels = 0;                          ///< of co-contraction; 0: as the profile says
    std::optional<double> push_torque = {};  ///< of the push-and-release test [Nm]; none: as the profile says
    std::vector<Eigen::Vector3d> at = {};    ///< torques (tau_1, tau_2, tau_q) at which the equilibrium is asked for [Nm]
    bool force = false;                      ///< where files are written: as core::OutputRun has it
};

/// The joint that a profile describes, at rest and pushed, with its motor and frame subsystems and its noise; of the paper's relatives the
/// comparison only. Needs no parts.
/// Refusal: the law's; why an equilibrium asked for does not exist stands in its row. @throws core::InvalidInput
[[nodiscard]] core::Outcome<report::Simulation> simulate(const profile::Profile& profile, const SimulateOptions& options = {});

/// Writes simulation.json, dead_band.csv and simulation.html into `folder`, which is made if it is missing; each file whole or
/// not at all, every other file left alone. @throws core::IoError
std::vector<report::FileRow> write_simulation(const report::Simulation& simulation, const std::filesystem::path& folder);

/// The profile's joint with its bearing.
[[nodiscard]] actuator::Joint joint_of(const profile::Profile& profile, const spring::SpringLawPtr& law);
/// The same with each spring tabulated once (spring::resampled), for paths of thousands of steps; the gears without friction if `gears` is
/// false (paper: the frame subsystem).
[[nodiscard]] actuator::Joint path_joint_of(const profile::Profile& profile, const spring::SpringLawPtr& law, bool gears = true);

/// Equilibrium (1), sensitivity (2) and dead-band under any three torques, or why there is none.
/// @throws core::InvalidInput if a torque is not finite
[[nodiscard]] report::EquilibriumRow equilibrium_at(const actuator::Joint& joint, const Eigen::Vector3d& torque);

/// All three dead-bands at one co-contraction. @param joint the actuator's, with its bearing
[[nodiscard]] report::SimulatedLevel simulate_level(const actuator::Actuator& actuator, const actuator::Joint& joint, double tau,
                                                    const actuator::ReleaseTest& test = {});

/// The path of a push-and-release test with `push_torque` [Nm], both ways.
[[nodiscard]] report::ReleasePath release_path(const actuator::Joint& joint, double tau, double push_torque);
/// The joint torque cycled between +-`torque` [Nm] until the path repeats.
[[nodiscard]] report::DeflectionLoop deflection_loop(const actuator::Joint& joint, double tau, double torque);
/// What friction makes of each cable on its cam; empty where the profile has no parts, or no friction and stiffness of its cable.
[[nodiscard]] std::vector<report::WrapSide> wrap_sides(const profile::Profile& profile, const spring::SpringLawPtr& law);
/// What each cable's stretch takes of the capstan's travel; empty where the profile has no parts, or no cable of it stretches.
[[nodiscard]] std::vector<report::StretchSide> stretch_sides(const profile::Profile& profile, const spring::SpringLawPtr& law);
/// Figure 8 for `count` motor torques from 0 to `greatest`.
[[nodiscard]] std::vector<report::BreakAwayRow> break_away_rows(const friction::Law& gear, double greatest, std::size_t count);

}  // namespace fusee::pipeline
