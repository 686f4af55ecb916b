#pragma once
#include "fusee/solid/mesh.h"

namespace fusee::checks {

/// Area of faces that look down by more than `overhang` from the vertical [rad] and do not lie on the bed [mm^2].
/// @param flipped the part stands on its top, z_high, in place of its bottom
[[nodiscard]] double unsupported_mm2(const solid::Mesh& mesh, double overhang, bool flipped);

/// Does the part need less support on its top than on its bottom? The way up that `fdm.support` is judged for.
[[nodiscard]] bool prints_on_its_top(const solid::Mesh& mesh, double overhang);

}  // namespace fusee::checks
