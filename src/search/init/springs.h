#pragma once
#include <optional>

#include "fusee/core/finding.h"
#include "fusee/profile/profile.h"

namespace fusee::search::init {

inline constexpr int kSpringDigits = 6;  ///< of the figures of a wound spring

/// The profile with a spring for this part that can be wound. @returns as with_springs
[[nodiscard]] core::Outcome<profile::Profile> with_spring(const profile::Profile& profile, cam::PartKind part);

/// The profile with springs that can be wound, and with the slot for the leg of K_SE's: the smallest that no rule refuses, warnings
/// avoided where possible. Refusal: the rules that most candidates broke.
[[nodiscard]] core::Outcome<profile::Profile> with_springs(const profile::Profile& profile);

}  // namespace fusee::search::init
