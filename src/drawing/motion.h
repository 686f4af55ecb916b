#pragma once
#include <vector>

#include "fusee/drawing/drawing.h"
#include "marks.h"
#include "view.h"

/// What moves, on the front view: the cable at the least load and the turn from there.
namespace fusee::drawing {

/// Line, arrow and callout of the cable; nothing for a roller cam. @param box the outline on the sheet
[[nodiscard]] std::vector<Callout> draw_cable_exit(Sheet& sheet, const Subject& subject, const View& view, const Box& box);
/// An arc with an arrow in the sense in which the part turns as the load rises.
[[nodiscard]] Callout draw_turn(Sheet& sheet, const Subject& subject, const View& view);
/// Both ends of the working arc, P at the least load and Q at the largest: a tick, and its letter in a clear place.
void draw_arc_ends(Sheet& sheet, const solid::Part& part, const View& view);

}  // namespace fusee::drawing
