#pragma once
#include "fusee/cam/arm.h"
#include "fusee/cam/cam.h"
#include "fusee/spring/law.h"

namespace fusee::search::codesign {

/// Figures of a contour's working arc, even if it cannot be cut: measured on contacts alone, to guide a search.
struct Shape {
    double least_rho = 0.0;  ///< radius of curvature [m]; NaN where the cable has no tangent
    double least_arm = 0.0;  ///< [m]
    double radius = 0.0;     ///< largest distance of the centreline from the axis [m]
    double wrap = 0.0;       ///< of normals [rad]
};
[[nodiscard]] Shape shape_of(const cam::ArmFunction& arm, const cam::CamOptions& options);

/// Largest distance of a finished contour's centreline from the axis, idle arc and run-outs included [m].
[[nodiscard]] double contour_radius(const cam::Cam& cam);

}  // namespace fusee::search::codesign
