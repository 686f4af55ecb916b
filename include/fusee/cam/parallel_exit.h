#pragma once
#include <cstddef>

#include "fusee/cam/cam.h"

namespace fusee::cam {

/// The largest error of a cam's arms, and its place.
struct ExitError {
    double relative = 0.0;  ///< |arm found / arm wanted - 1|; NaN where no cable is straight from the hole to the contour
    std::size_t row = 0;    ///< of `Cam::working`
};

/// A cam cut for a parallel exit, with its cable led to a hole instead (docs/theory/cams.md, eq. 7a): the largest relative error of the arm
/// over the working positions, by the tangent from the hole to the cable's path on the cam.
/// @param distance axis to hole [m]. The hole is on the line of the cable that has the mean of the least and the largest arm, so that the
/// real cable is inclined as little to one side as to the other
/// @pre the cam has working positions and a parallel exit
[[nodiscard]] ExitError parallel_exit_error(const Cam& cam, double distance);

/// The least distance of a hole in [low, high] beyond which that error is at most `relative`, to 0.1 %. `high` if it is above it there. [m]
[[nodiscard]] double least_parallel_distance(const Cam& cam, double relative, const core::Range& distance);

}  // namespace fusee::cam
