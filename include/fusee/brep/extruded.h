#pragma once
#include <span>

#include "fusee/brep/brep.h"
#include "fusee/solid/extrusion.h"

namespace fusee::brep {

/// The union of shapes that touch but do not overlap, of plane and cylinder faces. Shapes with a common face become one solid, in which
/// faces of one surface are one face; those that meet nowhere, or in a line only, stay solids of their own, one after the other.
/// Refusal "brep.validity": the solids are not valid, or their volume is not the sum of the shapes' volumes (shapes overlap). @pre at least
/// one shape
[[nodiscard]] core::Outcome<Brep> extruded(std::span<const solid::Extrusion> shapes);

}  // namespace fusee::brep
