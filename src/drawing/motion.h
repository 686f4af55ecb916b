#pragma once
#include <vector>

#include "fusee/drawing/drawing.h"
#include "marks.h"
#include "view.h"

/// What moves, on the front view: the cable or the follower's arm at the least load and the turn from there.
namespace fusee::drawing {

/// Line, arrow and callout of the cable; of a roller on an arm the roller, the arm and its pivot, or an arrow towards it where the view
/// ends; of a slide nothing. @param box the outline on the sheet
[[nodiscard]] std::vector<Callout> draw_partner(Sheet& sheet, const Subject& subject, const View& view, const Box& box);
/// An arc with an arrow in the sense in which the part turns as the load rises.
[[nodiscard]] Callout draw_turn(Sheet& sheet, const Subject& subject, const View& view);
/// Both ends of the working arc, P at the least load and Q at the largest: a tick, and its letter in a clear place.
void draw_arc_ends(Sheet& sheet, const solid::Part& part, const View& view);

}  // namespace fusee::drawing
