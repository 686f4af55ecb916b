#pragma once
#include "fusee/drawing/drawing.h"

namespace fusee::drawing {

/// The groove's section with its flanges and the cable in it, enlarged and dimensioned; a roller cam has none.
void draw_groove(Sheet& sheet, const Subject& subject, const Box& room);

}  // namespace fusee::drawing
