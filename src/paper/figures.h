#pragma once
#include "fusee/core/finding.h"
#include "fusee/paper/paper.h"
#include "fusee/profile/profile.h"

/// The paper's tables and figures (Fiorio et al., RSS 2014), each reproduced by one function.
namespace fusee::paper {

/// Figure 1 for noises at both bodies, at one of them, without the motor's spring to ground, and without both springs (no bound). The paper
/// prints no numbers: inertias, a and b are 1, dampers 0.5, densities 1.
[[nodiscard]] std::vector<NoiseCurve> noise_figure();

/// Figure 2 with the profile's springs: linear ones as stiff as those at the motors' peak torque, then the nonlinear ones themselves.
/// Refusal: the law's. @throws core::InvalidInput
[[nodiscard]] core::Outcome<HillFigure> hill_figure(const profile::Profile& profile);

/// Table I or II, and figure 6: the profile's joint simulated, with its measured rows.
/// Refusal: the law's. @throws core::InvalidInput, also if the profile has no measured rows
[[nodiscard]] core::Outcome<PaperTable> replay_table(const profile::Profile& profile);

}  // namespace fusee::paper
