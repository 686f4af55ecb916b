#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/solid/extrusion.h"
#include "fusee/solid/part.h"

class TopoDS_Shape;

namespace fusee::exchange::brep {

/// A plane B-spline: knots repeated by their multiplicities.
struct PlaneSpline {
    int degree = 3;
    std::vector<double> knots;
    std::vector<std::array<double, 2>> control_mm;
};

/// The pitch curve's parallel at `offset_mm` along its normal, seen from +z, as the splines of STEP's faces: by rising psi, within 0.0002
/// mm, of a part for a roller within 0.00001 mm; those of a planar part form a closed curve.
[[nodiscard]] std::vector<PlaneSpline> outline_splines(const solid::Part& part, double offset_mm);

/// A part as one solid of exact faces: splines along the contour, true circles across the groove's floor, planes and cylinders elsewhere.
struct Brep {
    std::shared_ptr<const TopoDS_Shape> shape;  ///< OpenCASCADE's, in millimetres, body frame
    std::size_t faces = 0;
    double volume_mm3 = 0.0;    ///< as clients read it (brep::volume_mm3)
    double deviation_mm = 0.0;  ///< of the spline faces from the analytic surface, the largest half-way between their nodes
};

/// Builds it from the parametric surface (docs/theory/cams.md); Booleans only for anchor hole, leg slot, mark and set screw.
/// Refusal: "brep.validity" (not one valid solid, or its volume by OpenCASCADE's default integral differs
/// from that of the mesh by more than 0.05 %; then the suggestion is a chordal error with which it agrees).
[[nodiscard]] core::Outcome<Brep> build(const solid::Part& part);

/// The union of shapes that touch but do not overlap, of plane and cylinder faces. Shapes with a common face become one solid, in which
/// faces of one surface are one face; those that meet nowhere, or in a line only, stay solids of their own, one after the other.
/// Refusal "brep.validity": the solids are not valid, or their volume is not the sum of the shapes' volumes (shapes overlap). @pre at least
/// one shape
[[nodiscard]] core::Outcome<Brep> extruded(std::span<const solid::Extrusion> shapes);

/// The mirror image of a solid, y -> -y (cam::mirrored): reflected surfaces with faces that are turned outward again. It is built from
/// the finished solid, which is far faster than from the mirrored part; its volume is the solid's. Refusal "brep.validity" if OpenCASCADE
/// then finds no valid solid with the same number of faces that encloses its inside.
[[nodiscard]] core::Outcome<Brep> mirrored(const Brep& solid);

}  // namespace fusee::exchange::brep
