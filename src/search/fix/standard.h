#pragma once
#include <optional>
#include <string>
#include <vector>

#include "draft.h"

namespace fusee::search::fix {

/// A suggested change in sizes on sale, with the changes that follow from it; or why it is refused.
struct Held {
    core::Changes changes;  ///< empty: refused
    Follows follows;        ///< of the keys that were joined: the key that they follow
    std::string key;        ///< refused: of the refused change
    std::string refused;    ///< refused: why, e.g. "its breaking load is not stated (cable.breaking_load_N)"
};

/// Limits changes to sizes on sale (checks/limits.h) and to parts known to be strong enough (docs/guides/fix.md):
///   - shaft, cable, set screw and spring wire come in standard sizes, on the side of the present value on which the suggestion lies;
///     a spring rate in those of `co_design.catalogue` if the profile names one
///   - a thinner cable keeps its strength per area; without a stated breaking load a cable does not become thinner; no cable bears more
///     than the strongest on sale
///   - a key follows its shaft by DIN 6885; a shaft becomes thinner only if steel bears the cam's torque
///   - stated coils follow the rate, wire or coil diameter of their spring, a stated rate other coils, so that they agree
///   - keys that the user keeps stay
/// @param draft the profile that the changes are made to
[[nodiscard]] Held hold(const core::Changes& changes, const profile::Profile& draft, const Drafts& drafts);

/// The value of a key that follows others of its base spring in `draft`, in its unit: the active coils from rate, wire and coil diameter,
/// the rate from the coils; none for another key, or where wire or coil diameter is not known.
[[nodiscard]] std::optional<double> settled_follower(const std::string& key, const profile::Profile& draft);

/// Is the draft's cable thinner than the original's, with more strength per area?
[[nodiscard]] bool overrates_cable(const profile::Profile& draft, const profile::Profile& original);

/// The springs of the profile's catalogue for a part, as changes of its spring's keys, nearest rate first; empty without a catalogue.
[[nodiscard]] std::vector<core::Changes> catalogue_springs(const std::string& part, const profile::Profile& draft);

}  // namespace fusee::search::fix
