#pragma once
#include "fusee/profile/profile.h"
#include "fusee/report/report.h"
#include "fusee/report/simulation.h"

namespace fusee::pipeline {

/// What the user gets: the dead-band over the co-contractions in use, also of joints as built; the arms as the process makes them; the
/// joint torque within the springs' laws.
/// @param simulation of the same profile and law @param parts K_SE's and K_PE's
[[nodiscard]] report::Outlook outlook_of(const profile::Profile& profile, const spring::SpringLawPtr& law,
                                         const report::Simulation& simulation, const std::vector<report::PartReport>& parts);

}  // namespace fusee::pipeline
