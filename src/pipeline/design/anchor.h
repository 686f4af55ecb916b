#pragma once
#include <optional>

#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

/// A cam with its anchor in place.
struct AnchoredCam {
    cam::Cam cam;
    std::optional<solid::Part> outline;  ///< its body without a mesh, where the search for the place has made it
};

/// A margin that the profile does not state follows from the contour: the planar cam with its anchor at the nearest angle to its own at
/// which no rule about the anchor objects, else at the nearest without an error, else where it is.
[[nodiscard]] AnchoredCam with_anchor_placed(cam::Cam cam, const ResolvedDesign& design);

}  // namespace fusee::pipeline
