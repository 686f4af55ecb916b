#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "fusee/solid/outline.h"

namespace fusee::solid {

struct RoundHole {
    double x_mm = 0.0, y_mm = 0.0, radius_mm = 0.0;
};

/// A disc, ring, rod or plate: from z = 0 to `length_mm` of its own frame, with holes along z. [mm]
struct Extrusion {
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();  ///< from its own frame to that of its body
    double radius_mm = 0.0;                                   ///< round; 0: rectangular
    double half_x_mm = 0.0, half_y_mm = 0.0;                  ///< rectangular
    double length_mm = 0.0;
    Outline outline;               ///< not empty: neither round nor rectangular; within `radius_mm` of the axis
    std::vector<RoundHole> holes;  ///< inside the outline, apart from each other
    std::vector<Outline> bores;    ///< holes that are not round, as `holes`
};

/// Its rim in its own frame, as `ring_of` of an outline; of a rectangle its corners.
[[nodiscard]] Ring ring_of(const Extrusion& shape, double tolerance_mm);

}  // namespace fusee::solid
