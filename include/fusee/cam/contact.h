#pragma once
#include <cstddef>
#include <vector>

#include "fusee/cam/cam.h"

/// Places on a cam and beside it: where the cable touches it, is held by it and leaves it.
namespace fusee::cam {

/// +1 when the cam draws cable in as it turns (K_PE), -1 when it pays cable out (K_SE).
[[nodiscard]] int winding_sign(PartKind kind);
/// At cam angle a the body is turned by this sign times a: with the tension's torque for K_SE, against it for K_PE.
[[nodiscard]] int rotation_sign(PartKind kind, int torque_sign);

/// The cable's contact with the cam at the arm `arm`, in the body frame (docs/theory/cams.md, eq. 3 to 7). With sigma = winding_sign,
/// c = r + sR, S = sqrt(D^2 - c^2), w = 1 + sigma r'/S: h = r, dpsi/dangle = sigma torque_sign w, h' = sigma torque_sign r'/w,
/// rho = r + (r'' - sigma c r'^3/S^3)/w^3, free span S^2/(S + sigma r').
/// path.z is 0; path.rho is NaN where no tangent exists (|c| >= D or S + sigma r' <= 0): see `guide_margin`.
[[nodiscard]] Contact touch(PartKind kind, const ArmPoint& arm, const CamOptions& options);

/// Margin up to which a tangent exists at this arm: min(D - |c|, S + sigma r') [m]; infinity for a parallel exit. Must be > 0.
[[nodiscard]] double guide_margin(PartKind kind, const ArmPoint& arm, const CamOptions& options);

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

/// Direction psi of the cable's anchor: `margin` [rad] beyond the working arc, at its wound end; of a planar cam within its groove.
[[nodiscard]] double anchor_direction(const Cam& cam, double margin);

/// Margins to try for an anchor that is in the way [rad]: the cam's own first, then every 5 deg, the nearer first, 5 to 170 deg.
[[nodiscard]] std::vector<double> margins_by_distance(const Cam& cam);

/// The planar cam with its anchor elsewhere on the same contour. @pre cam.closed()
[[nodiscard]] Cam with_margin(Cam cam, double margin);

}  // namespace fusee::cam
