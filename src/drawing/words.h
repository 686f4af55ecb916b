#pragma once
#include <string>
#include <vector>

#include "fusee/drawing/drawing.h"

/// What callouts say of the hub and of features, at most 24 letters a line.
namespace fusee::drawing {

using Words = std::vector<std::string>;

[[nodiscard]] Words bore_words(const Subject& subject);
/// Keyway or flat; empty where there is neither.
[[nodiscard]] Words lock_words(const solid::HubOptions& hub);
[[nodiscard]] Words slot_words(const solid::FeatureOptions& features);
[[nodiscard]] Words mark_words(const solid::FeatureOptions& features);

/// What holds for the whole part, a sentence or two each.
[[nodiscard]] Words notes(const Subject& subject);

}  // namespace fusee::drawing
