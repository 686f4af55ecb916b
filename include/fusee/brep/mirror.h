#pragma once
#include "fusee/brep/brep.h"

namespace fusee::brep {

/// The mirror image of a solid, y -> -y (fusee/cam/mirror.h): its surfaces reflected, its faces turned outward again. Built from the
/// finished solid, which is far cheaper than from the mirrored part. Refusal "brep.validity" if OpenCASCADE then finds no valid solid of
/// the same volume.
[[nodiscard]] core::Outcome<Brep> mirrored(const Brep& solid);

}  // namespace fusee::brep
