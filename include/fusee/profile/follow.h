#pragma once
#include <vector>

#include "fusee/profile/edit.h"

/// Keys that follow from others: which of a profile's stated values are no longer right when others move (docs/profile.md).
namespace fusee::profile {

/// The edits that keep a profile consistent with `moved`, keys of numbers with other values. Keys that move and keys that the profile does
/// not state are left alone. An edit without a value leaves its key out, so that it is derived again:
/// - rate, wire, coil diameter or modulus of a base spring: its active coils;  active coils: its rate;
/// - any of these: its free length and, where the strength of its wire is known, its rating; its rod keeps its share of the inside
///   diameter, and K_SE's leg slot its play and its place at the coils;
/// - cable.diameter_mm: the breaking load (by the square), and the rounded edges of the anchor holes;
/// - hub.bore_mm: key_width_mm and key_depth_mm, where both are those of DIN 6885.
/// Nothing follows in a base spring whose wire or coil diameter is not known.
[[nodiscard]] std::vector<Edit> following(const Profile& profile, const std::vector<Edit>& moved);

/// The stated margins of anchors that follow from a contour which `moved` changes: the profile then treats them as a start
/// (pipeline::design_cam moves an anchor that is in the way), no longer as stated.
void let_anchors_follow(Profile& profile, const std::vector<Edit>& moved);

}  // namespace fusee::profile
