#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

#include "fusee/solid/cutters.h"
#include "side.h"

namespace fusee::exchange::brep {

/// The flat faces, the boss and the bore, which close a part's side.
[[nodiscard]] std::vector<TopoDS_Shape> closing_faces(const Side& side, const solid::HubOptions& hub);
/// Upright, with holes from end to end and true arcs.
[[nodiscard]] TopoDS_Shape prism(const solid::Outline& outline, const std::vector<solid::Outline>& holes, double low_mm, double high_mm);
/// A cutter with true arcs.
[[nodiscard]] TopoDS_Shape prism(const solid::Cutter& cutter);

}  // namespace fusee::exchange::brep
