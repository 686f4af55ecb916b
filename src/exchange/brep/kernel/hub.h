#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

#include "fusee/solid/cutters.h"
#include "side.h"

namespace fusee::exchange::brep {

/// The flat faces, the boss and the bore, which close a part's side.
[[nodiscard]] std::vector<TopoDS_Shape> closing_faces(const Side& side, const solid::HubOptions& hub);
/// A cutter with true arcs.
[[nodiscard]] TopoDS_Shape prism(const solid::Cutter& cutter);

}  // namespace fusee::exchange::brep
