#pragma once
#include <array>
#include <vector>

#include "fusee/solid/part.h"

namespace fusee::brep {

/// A plane B-spline: knots with their multiplicities, one after the other.
struct PlaneSpline {
    int degree = 3;
    std::vector<double> knots;
    std::vector<std::array<double, 2>> control_mm;
};

/// The pitch curve's parallel at `offset_mm` along its normal, seen from +z, as the splines that STEP's faces are made from: one after the
/// other by rising psi, within 0.0002 mm; those of a planar part close.
[[nodiscard]] std::vector<PlaneSpline> outline_splines(const solid::Part& part, double offset_mm);

}  // namespace fusee::brep
