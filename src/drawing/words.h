#pragma once
#include <string>
#include <vector>

#include "fusee/drawing/drawing.h"

/// Callouts of the hub and of features, at most 24 letters per line.
namespace fusee::drawing {

using Words = std::vector<std::string>;

[[nodiscard]] Words bore_words(const Subject& subject);
/// Keyway or flat; empty if there is neither.
[[nodiscard]] Words lock_words(const solid::HubOptions& hub);
[[nodiscard]] Words slot_words(const solid::FeatureOptions& features);
[[nodiscard]] Words mark_words(const solid::FeatureOptions& features);

/// Notes on the whole part, one or two sentences each.
[[nodiscard]] Words notes(const Subject& subject);

}  // namespace fusee::drawing
