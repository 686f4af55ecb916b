#pragma once
#include "fusee/core/finding.h"
#include "fusee/profile/profile.h"
#include "fusee/spring/law.h"

namespace fusee::pipeline {

/// The law that `profile.law` describes, without its lead-in. Refusal and @throws: those of its maker in room spring; a formula's mistake
/// names its key.
[[nodiscard]] core::Outcome<spring::SpringLawPtr> spring_law(const profile::Profile& profile);

}  // namespace fusee::pipeline
