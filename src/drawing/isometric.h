#pragma once
#include <vector>

#include "fusee/drawing/sheet.h"
#include "fusee/solid/mesh.h"

namespace fusee::drawing {

/// Visible edges of a closed mesh in a parallel projection [mm], second axis upwards: edges whose faces differ by more than 25 degrees, and
/// the silhouette, seen from (1, -1, 1), or (1, -1, -1) with `from_below`. Visibility is decided by a raster of depths of 1/800 of the
/// view: a line may end that much too early or too late.
[[nodiscard]] std::vector<Line> isometric(const solid::Mesh& mesh, bool from_below);

}  // namespace fusee::drawing
