#pragma once
#include <functional>
#include <vector>

#include "fusee/solid/outline.h"

namespace fusee::toolpath {

/// A point of a convex outline whose outward normal has the direction psi [mm].
using ConvexOutline = std::function<solid::Point2(double psi)>;

/// Arcs that follow a closed convex outline counter-clockwise, each `begin` to `end` in psi, joined without a corner: between two normals
/// stands the pair of arcs that has both end points and both end tangents (docs/theory/toolpaths.md, eq. 1). No arc is farther from the
/// outline than `tolerance_mm`: of convex curves the largest distance is that of their support functions, which is what is measured.
/// @param start psi at which the ring begins and, a turn on, ends
/// @pre the outline's radius of curvature is above 0
[[nodiscard]] std::vector<solid::Arc> fit_arcs(const ConvexOutline& outline, double start, double tolerance_mm);

/// The parallel ring at a distance outside (above 0) or inside. @pre every radius stays above 0
[[nodiscard]] std::vector<solid::Arc> parallel(std::vector<solid::Arc> ring, double offset_mm);

/// The ring as it looks from below: turned over about the x axis, still counter-clockwise, beginning where it began.
[[nodiscard]] std::vector<solid::Arc> turned_over(const std::vector<solid::Arc>& ring);

}  // namespace fusee::toolpath
