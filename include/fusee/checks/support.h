#pragma once
#include "fusee/solid/mesh.h"

namespace fusee::checks {

/// Area of downward faces at more than `overhang` from the vertical [rad] that do not lie on the bed [mm^2].
/// @param flipped the part stands on its top, z_high, instead of its bottom
[[nodiscard]] double unsupported_mm2(const solid::Mesh& mesh, double overhang, bool flipped);

/// Does the part need less support on its top than on its bottom? `fdm.support` judges the better of the two.
[[nodiscard]] bool prints_on_its_top(const solid::Mesh& mesh, double overhang);

}  // namespace fusee::checks
