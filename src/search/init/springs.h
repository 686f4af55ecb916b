#pragma once
#include <vector>

#include "fusee/search/init.h"

/// Springs of a first profile: which can hold the law, and which are wound for it.
namespace fusee::search::init {

/// Work and preload of both springs, and the springs that hold them. @pre a measured law is a pair of springs
[[nodiscard]] std::vector<Store> stores_of(const Answers& answers, const spring::Catalogue& catalogue);

/// "init.energy" for each spring that no wire can hold; empty: none.
[[nodiscard]] core::Findings not_held(const std::vector<Store>& stores);

inline constexpr int kSpringDigits = 6;  ///< of the figures of a wound spring

/// The profile with a spring for this part that can be wound. @returns as with_springs
[[nodiscard]] core::Outcome<profile::Profile> with_spring(const profile::Profile& profile, cam::PartKind part);

/// The profile with springs that can be wound, and with the slot for the leg of K_SE's: the smallest that no rule refuses, warnings
/// avoided where possible. Refusal: the rules that most candidates broke.
[[nodiscard]] core::Outcome<profile::Profile> with_springs(const profile::Profile& profile);

}  // namespace fusee::search::init
