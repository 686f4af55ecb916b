#pragma once
#include "fusee/cam/cam.h"
#include "fusee/core/units.h"

namespace fusee::report {

/// Key figures of a cam.
struct CamFigures {
    double travel = 0.0;  ///< cam rotation over the law [rad]
    core::Range arms_mm;
    core::Range tensions;       ///< cable [N]
    core::Range states;         ///< of the base spring [rad] or [m]
    double least_rho_mm = 0.0;  ///< radius of curvature of the pitch curve on the working arc
};
/// @pre cam.working is not empty
[[nodiscard]] CamFigures measure(const cam::Cam& cam);

}  // namespace fusee::report
