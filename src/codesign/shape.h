#pragma once
#include "fusee/cam/arm.h"
#include "fusee/cam/cam.h"
#include "fusee/spring/law.h"

namespace fusee::codesign {

/// What a contour's working arc would be, whether or not it can be cut: measured on contacts alone, so that a search can be led.
struct Shape {
    double least_rho = 0.0;  ///< radius of curvature [m]; NaN where the cable has no tangent
    double least_arm = 0.0;  ///< [m]
    double radius = 0.0;     ///< largest distance of the centreline from the axis [m]
    double wrap = 0.0;       ///< of normals [rad]
};
[[nodiscard]] Shape shape_of(const cam::ArmFunction& arm, const cam::CamOptions& options);

/// Largest distance of a finished contour's centreline from the axis, idle arc and run-outs included [m].
[[nodiscard]] double contour_radius(const cam::Cam& cam);

}  // namespace fusee::codesign
