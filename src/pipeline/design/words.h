#pragma once
#include "fusee/core/finding.h"
#include "fusee/profile/profile.h"

namespace fusee::pipeline {

/// The findings about a part in the words of the profile. Of a single spring, the rules' "k_pe" is its "cam", and the place at which its
/// law may end, an angle instead of a load, is a key of its own: law.to_deg.
[[nodiscard]] core::Findings in_words_of(const profile::Profile& profile, core::Findings findings);

}  // namespace fusee::pipeline
