#pragma once
#include <string>
#include <vector>

#include "badge.h"
#include "fusee/drawing/drawing.h"

/// Callouts of the hub and of features, at most 24 letters per line.
namespace fusee::drawing {

using Words = std::vector<std::string>;

/// Of a single spring the part's law is over its angle, of its cable that pulls back ("cam_back") from the last angle down.
[[nodiscard]] bool is_of_spring(const Subject& subject);
[[nodiscard]] bool pulls_back(const Subject& subject);
/// Where the law of the part begins, and the adjective of where it ends: "first angle", "last".
[[nodiscard]] const char* beginning_of(const Subject& subject);
[[nodiscard]] const char* end_of(const Subject& subject);

[[nodiscard]] Words bore_words(const Subject& subject);
/// Datum A, and the roughness.
[[nodiscard]] std::vector<Badge> bore_badges(const Subject& subject);
/// Position to A, and datum B.
[[nodiscard]] std::vector<Badge> lock_badges(const Subject& subject);
[[nodiscard]] Words flat_words(const solid::HubOptions& hub);
/// Keyway or flat; empty if there is neither.
[[nodiscard]] Words lock_words(const Subject& subject);
/// How deep an opening in the top face is; of a stack the plates that it goes through. @param opening its name in solid::Cutter
[[nodiscard]] std::string deep_words(const solid::Part& part, const char* opening, double depth_mm);
[[nodiscard]] Words slot_words(const solid::Part& part);
[[nodiscard]] Words mark_words(const solid::Part& part);

/// Notes on the whole part, one or two sentences each.
[[nodiscard]] Words notes(const Subject& subject);
/// What the tolerances are, where their values come from, and what they cost the arm.
[[nodiscard]] Words tolerance_notes(const Subject& subject);
/// How the check rows are measured.
[[nodiscard]] Words check_notes(const solid::Part& part);

}  // namespace fusee::drawing
