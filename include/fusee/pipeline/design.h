#pragma once
#include "fusee/actuator/actuator.h"
#include "fusee/core/finding.h"
#include "fusee/friction/law.h"
#include "fusee/profile/profile.h"
#include "fusee/solid/part.h"
#include "fusee/spring/law.h"

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

/// What simulating needs is in every profile, what making needs is not. @throws core::InvalidInput naming the first key that is missing
void require_parts(const profile::Profile& profile);

/// One cam as a solid, with what every rule says of it.
struct DesignedPart {
    solid::Part part;
    core::Findings findings;
};
/// Arm, cam, solid, rules. Refusal: the findings, when a required change is among them.
/// @pre require_parts(profile)
[[nodiscard]] core::Outcome<DesignedPart> design_part(cam::PartKind kind, const profile::Profile& profile, const spring::SpringLawPtr& law);

}  // namespace fusee::pipeline
