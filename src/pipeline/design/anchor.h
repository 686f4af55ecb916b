#pragma once
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

/// A margin that the profile does not state follows from the contour: the planar cam with its anchor at the nearest angle to its own at
/// which no rule about the anchor objects, else at the nearest without an error, else where it is.
[[nodiscard]] cam::Cam with_anchor_placed(cam::Cam cam, const ResolvedDesign& design);

}  // namespace fusee::pipeline
