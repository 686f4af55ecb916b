#pragma once
#include <optional>
#include <vector>

#include "fusee/solid/mesh.h"

namespace fusee::solid {

/// Body minus every tool, slivers left in: as the Boolean of whole solids, but only the triangles near a tool take part. Which side of a
/// surface goes follows from the sides where both surfaces meet. None where that does not decide: no common curve, surfaces that only
/// touch, a body that lies all within a tool's box, or triangles that form no manifold.
/// @pre as `cut`
[[nodiscard]] std::optional<Mesh> cut_locally(const Mesh& body, const std::vector<Mesh>& tools);

}  // namespace fusee::solid
