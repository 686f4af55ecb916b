#pragma once
#include "fusee/actuator/actuator.h"
#include "fusee/core/finding.h"
#include "fusee/friction/law.h"
#include "fusee/profile/profile.h"
#include "fusee/solid/part.h"
#include "fusee/spring/law.h"

namespace fusee::design {
struct Drawing;
}

namespace fusee::pipeline {

/// The law that `profile.law` describes, without its lead-in. Refusal and @throws: those of its maker in room spring; a formula's mistake
/// names its key.
[[nodiscard]] core::Outcome<spring::SpringLawPtr> spring_law(const profile::Profile& profile);

/// The spring law that a profile asks for, lead-in included, and what is known of it.
struct DesignedLaw {
    spring::SpringLawPtr law;
    core::Range design_loads;  ///< without the lead-in [Nm]
    core::Findings findings;   ///< passes and reviews: coverage of the loads that stiction allows
};
/// Refusals: whatever the law's maker, its lead-in or `spring::check_law` finds broken.
[[nodiscard]] core::Outcome<DesignedLaw> design_law(const profile::Profile& profile);

/// The friction of both gears that a profile asks for. @throws core::InvalidInput naming the row of its table
[[nodiscard]] friction::Law gear_friction(const profile::Profile& profile);

/// The joint that the law drives.
[[nodiscard]] actuator::Actuator actuator_of(const profile::Profile& profile, const spring::SpringLawPtr& law);

/// That joint and the linear springs that its cams pull, each cable of K_PE counted to its spring: what a shop's scatter is taken from.
[[nodiscard]] design::Drawing drawing_of(const profile::Profile& profile, const spring::SpringLawPtr& law);

/// What simulating needs is in every profile, what making needs is not; and a kerf has to leave a bore.
/// @throws core::InvalidInput naming the first key that is missing or at odds with another
void require_parts(const profile::Profile& profile);
/// What is to be sliced has to be printed of beads. @throws core::InvalidInput naming outputs.formats
void require_sliceable(const profile::Profile& profile);

/// One cam's share of a profile.
[[nodiscard]] const profile::PartSpec& spec_of(cam::PartKind kind, const profile::Profile& profile);
/// Passes where the cable reaches round its cam to the anchor; nothing where the profile has no length of it.
[[nodiscard]] core::Findings check_cable_length(const cam::Cam& cam, const profile::Profile& profile);
/// Arm and cam, without a body. Refusal: the cam's. @pre require_parts(profile)
[[nodiscard]] core::Outcome<cam::Cam> design_cam(cam::PartKind kind, const profile::Profile& profile, const spring::SpringLawPtr& law);

/// One cam as a solid, with what every rule says of it.
struct DesignedPart {
    solid::Part part;
    core::Findings findings;
};
/// Arm, cam, solid, rules. Refusal: the findings, when a required change is among them; of a helix that meets itself the suggestion is
/// how steep it has to be, found by making it.
/// @pre require_parts(profile)
[[nodiscard]] core::Outcome<DesignedPart> design_part(cam::PartKind kind, const profile::Profile& profile, const spring::SpringLawPtr& law);

}  // namespace fusee::pipeline
