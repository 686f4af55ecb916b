#pragma once
#include "fusee/brep/brep.h"

namespace fusee::brep {

/// The mirror image of a solid, y -> -y (fusee/cam/mirror.h): reflected surfaces with faces that are turned outward again. It is built from
/// the finished solid, which is far faster than from the mirrored part; its volume is the solid's. Refusal "brep.validity" if OpenCASCADE
/// then finds no valid solid with the same number of faces that encloses its inside.
[[nodiscard]] core::Outcome<Brep> mirrored(const Brep& solid);

}  // namespace fusee::brep
