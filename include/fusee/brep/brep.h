#pragma once
#include <memory>

#include "fusee/core/finding.h"
#include "fusee/solid/part.h"

class TopoDS_Shape;

namespace fusee::brep {

/// A part as one solid of exact faces: splines along the contour, true circles across the groove's floor, planes and cylinders elsewhere.
struct Brep {
    std::shared_ptr<const TopoDS_Shape> shape;  ///< OpenCASCADE's, in millimetres, body frame
    std::size_t faces = 0;
    double volume_mm3 = 0.0;    ///< as clients read it (measure.h)
    double deviation_mm = 0.0;  ///< of the spline faces from the analytic surface, the largest half-way between their nodes
};

/// Builds it from the parametric surface (docs/theory/cams.md); Booleans only for anchor hole, leg slot, mark and set screw.
/// Refusal: "brep.validity" (not one valid solid, or its volume by OpenCASCADE's default integral differs
/// from that of the mesh by more than 0.05 %; then the suggestion is a chordal error with which it agrees).
[[nodiscard]] core::Outcome<Brep> build(const solid::Part& part);

}  // namespace fusee::brep
