#pragma once
#include "fusee/solid/part.h"

/// Mirror images in the plane of the cam's axis and its timing mark, y -> -y (fusee/cam/mirror.h).
namespace fusee::solid {

/// Points are reflected and triangles reversed, so that they still face outward.
[[nodiscard]] Mesh mirrored(const Mesh& mesh);
/// The leg slot's angle changes its sign; bore, key, flat, mark and set screw are their own images.
[[nodiscard]] PartOptions mirrored(const PartOptions& options);
/// The whole part, as `build_part` makes it from the mirrored cam and options, without a second build. Its mesh needs no second proof of
/// validity: reflection keeps every incidence and commutes with rounding to single precision.
[[nodiscard]] Part mirrored(const Part& part);

}  // namespace fusee::solid
