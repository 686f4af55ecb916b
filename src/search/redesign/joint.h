#pragma once
#include <array>

#include "fusee/actuator/joint.h"
#include "fusee/profile/profile.h"
#include "fusee/search/redesign.h"
#include "fusee/spring/law.h"

/// Cams of one profile on a rig with other figures.
namespace fusee::search::redesign {

/// Cams, the profile that they were cut for, and its law.
struct Cams {
    const profile::Profile* profile = nullptr;
    spring::SpringLawPtr law;
};
/// The spring that the spool or cam of `cams` makes of the base spring, cable and arms of `as_is` (docs/theory/springs.md, eq. 24 to 28).
[[nodiscard]] spring::PotentialPtr series_as_built(const Cams& cams, const profile::Profile& as_is);
[[nodiscard]] spring::PotentialPtr parallel_as_built(const Cams& cams, const profile::Profile& as_is);

/// The joint with those cams on each side, and with the friction and bearing of `as_is`.
[[nodiscard]] actuator::Joint joint_as_built(const std::array<Cams, 2>& cams, const std::array<profile::Profile, 2>& as_is);

/// Greatest |torque as built - law|/law of the four springs, over the deflections that both reach.
[[nodiscard]] double torque_error(const std::array<Cams, 2>& cams, const std::array<profile::Profile, 2>& as_is);

[[nodiscard]] DeadBandWidths dead_band_widths(const actuator::Joint& joint, double tau, double push_torque);

}  // namespace fusee::search::redesign
