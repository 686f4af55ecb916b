#pragma once
#include <string>
#include <vector>

#include "fusee/exchange/dxf.h"
#include "fusee/solid/part.h"

namespace fusee::exchange {

/// The plates of a stack (solid/stack.h), lowest first, one drawing per plate. Every line is cut through, except MARK. The outline of the
/// core is on the layer FLOOR (the floor of the groove) and on FLOOR_SPLINE; that of a flange is on FLANGE and FLANGE_SPLINE. Openings:
/// BORE, DOWEL, ANCHOR, LEG_SLOT. The number of ticks in MARK is the number of the plate from below; the first tick is at body angle 0. In
/// the core, ANCHOR crosses FLOOR: it opens into the groove and is cut first. Polylines stay within `kDrawingChord_mm`.
/// @pre a planar part for a cable, without a boss
[[nodiscard]] std::vector<DxfDrawing> stack_drawings(const solid::Part& part, const std::string& provenance);
/// The path of a beam or wire of width `kerf_mm`: outlines moved outwards and openings inwards by half the width. No other layers.
/// @throws InvalidInput naming outputs.kerf_mm if an opening would close
[[nodiscard]] std::vector<DxfDrawing> stack_kerf_drawings(const solid::Part& part, double kerf_mm, const std::string& provenance);

}  // namespace fusee::exchange
