#pragma once
#include "fusee/brep/brep.h"

namespace fusee::brep {

/// The mirror image of a solid, y -> -y (fusee/cam/mirror.h): reflected surfaces with faces that are turned outward again. It is built from
/// the finished solid, which is far faster than from the mirrored part. Refusal "brep.validity" if OpenCASCADE then finds no valid solid of
/// the same volume.
[[nodiscard]] core::Outcome<Brep> mirrored(const Brep& solid);

}  // namespace fusee::brep
