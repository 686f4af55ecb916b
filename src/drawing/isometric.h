#pragma once
#include "fusee/drawing/drawing.h"

namespace fusee::drawing {

/// Edges of a closed mesh in a parallel projection, without the hidden ones.
struct Projection {
    std::vector<Line> lines;  ///< [mm], second axis upwards
};
/// Edges whose faces differ by more than 25 degrees, and the silhouette, seen from (1, -1, 1), or (1, -1, -1) with `from_below`.
/// Visibility is decided by a raster of depths of 1/800 of the view: lines may end that much too early or too late.
[[nodiscard]] Projection isometric(const solid::Mesh& mesh, bool from_below);

void draw_isometric(Sheet& sheet, const Subject& subject, const Box& area);

}  // namespace fusee::drawing
