#pragma once
#include <string>
#include <vector>

#include "fusee/exchange/dxf.h"
#include "fusee/solid/part.h"

namespace fusee::exchange {

/// The plates of a stack (solid/stack.h), lowest first, each a drawing of its own that is cut through along every line. The core has its
/// outline on the layer FLOOR, which is the groove's floor, and again as FLOOR_SPLINE; the flanges on FLANGE and FLANGE_SPLINE. Openings:
/// BORE, DOWEL, ANCHOR, LEG_SLOT. MARK is not cut through: as many ticks side by side as the plate's number from below, the first at body
/// angle 0. In the core ANCHOR crosses FLOOR: it opens into the groove, and is cut first. Polylines stay within `kDrawingChord_mm`.
/// @pre a planar part for a cable, without a boss
[[nodiscard]] std::vector<DxfDrawing> stack_drawings(const solid::Part& part, const std::string& provenance);
/// What a beam or wire of width `kerf_mm` has to follow: outlines moved outwards by half of it, openings inwards, nothing else.
/// @throws InvalidInput naming outputs.kerf_mm where an opening would close
[[nodiscard]] std::vector<DxfDrawing> stack_kerf_drawings(const solid::Part& part, double kerf_mm, const std::string& provenance);

}  // namespace fusee::exchange
