#pragma once
#include <functional>
#include <vector>

#include "fusee/solid/outline.h"

namespace fusee::toolpath {

/// A point of a convex outline whose outward normal has the direction psi [mm].
using ConvexOutline = std::function<solid::Point2(double psi)>;

/// Arcs that follow a closed convex outline counter-clockwise, each `begin` to `end` in psi, joined without a corner. Between two normals a
/// pair of arcs has both end points and both end tangents (docs/theory/toolpaths.md, eq. 1). No arc is farther from the outline than
/// `tolerance_mm`. This is measured by the support functions: for convex curves their largest difference is the largest distance.
/// @param start psi at the start of the ring and, one turn later, at its end
/// @pre the outline's radius of curvature is above 0
[[nodiscard]] std::vector<solid::Arc> fit_arcs(const ConvexOutline& outline, double start, double tolerance_mm);

/// The parallel ring at a distance outside (above 0) or inside. @pre every radius stays above 0
[[nodiscard]] std::vector<solid::Arc> parallel(std::vector<solid::Arc> ring, double offset_mm);

/// The ring from below: turned over about the x axis, still counter-clockwise, with the same start.
[[nodiscard]] std::vector<solid::Arc> turned_over(const std::vector<solid::Arc>& ring);

}  // namespace fusee::toolpath
