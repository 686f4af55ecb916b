#pragma once
#include <array>
#include <vector>

#include "fusee/solid/part.h"

namespace fusee::brep {

/// A plane B-spline: knots repeated by their multiplicities.
struct PlaneSpline {
    int degree = 3;
    std::vector<double> knots;
    std::vector<std::array<double, 2>> control_mm;
};

/// The pitch curve's parallel at `offset_mm` along its normal, seen from +z, as the splines of STEP's faces: by rising psi, within 0.0002
/// mm; those of a planar part form a closed curve.
[[nodiscard]] std::vector<PlaneSpline> outline_splines(const solid::Part& part, double offset_mm);

}  // namespace fusee::brep
