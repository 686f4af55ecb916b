#pragma once
#include "fusee/solid/part.h"

/// Mirror images in the plane of the cam's axis and its timing mark, y -> -y (fusee/cam/mirror.h).
namespace fusee::solid {

/// Points reflected, triangles wound the other way: facing outward as before.
[[nodiscard]] Mesh mirrored(const Mesh& mesh);
/// The leg slot's angle changes its sign; bore, key, flat, mark and set screw are their own images.
[[nodiscard]] PartOptions mirrored(const PartOptions& options);
/// The whole part: what `build_part` makes of the mirrored cam and options, without building it again. Its mesh needs no second proof of
/// validity: reflection keeps every incidence, and rounding to single precision commutes with it.
[[nodiscard]] Part mirrored(const Part& part);

}  // namespace fusee::solid
