#pragma once
#include <vector>

#include "fusee/cam/cam.h"

namespace fusee::cam {

/// Direction psi of the cable's anchor: `margin` [rad] beyond the working arc, at its wound end; of a planar cam within its groove.
[[nodiscard]] double anchor_direction(const Cam& cam, double margin);

/// Margins to try for an anchor that is in the way [rad]: the cam's own first, then every 5 deg, the nearer first, 5 to 170 deg.
[[nodiscard]] std::vector<double> margins_by_distance(const Cam& cam);

/// The planar cam with its anchor elsewhere on the same contour. @pre cam.closed()
[[nodiscard]] Cam with_margin(Cam cam, double margin);

}  // namespace fusee::cam
