#pragma once
#include "fusee/drawing/drawing.h"

namespace fusee::drawing {

/// The groove's section with its flanges and the cable in it, enlarged and dimensioned; nothing for a roller cam.
void draw_groove(Sheet& sheet, const Subject& subject, const Box& area);

}  // namespace fusee::drawing
