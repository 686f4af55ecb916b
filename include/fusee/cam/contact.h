#pragma once
#include "fusee/cam/cam.h"

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

}  // namespace fusee::cam
