#pragma once
#include <array>
#include <vector>

namespace fusee::exchange {

/// A rational Bezier patch over (s, t) in [0, 1] x [0, 1].
struct BezierPatch {
    int rows = 0, columns = 0;                 ///< of poles: along s and t, at most kMostPoles in each direction
    std::vector<std::array<double, 4>> poles;  ///< (w x, w y, w z, w) [mm], w > 0; t varies first
    static constexpr int kMostPoles = 6;
};

struct PatchPoint {
    double s = 0.0, t = 0.0;
};

/// Where the line through (0, 0, z) at this azimuth, on both sides of the axis, crosses the patch; a crossing within 1e-7 outside its
/// border counts. By subdivision: a part whose poles are all on one side of the line's vertical plane or of its height has none
/// (convex hull), and one whose partial derivatives, as intervals, form a regular matrix has at most one, which Newton's method finds.
/// A part of 2^-8 of the patch is not divided further: of crossings nearer to each other than that, or where the line touches the patch,
/// one is found.
[[nodiscard]] std::vector<PatchPoint> crossings(const BezierPatch& patch, double azimuth, double z_mm);

}  // namespace fusee::exchange
