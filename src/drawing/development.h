#pragma once
#include "fusee/drawing/drawing.h"

namespace fusee::drawing {

/// The cylinder around a helix, unrolled: across the body angle as an arc of that cylinder, upwards z; the groove's centreline with P and
/// Q, heights, scale. Nothing for a planar part.
void draw_development(Sheet& sheet, const solid::Part& part, const Box& area);

}  // namespace fusee::drawing
