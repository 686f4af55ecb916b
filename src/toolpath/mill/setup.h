#pragma once
#include <map>
#include <optional>
#include <vector>

#include "fusee/toolpath/mill.h"

namespace fusee::toolpath::mill {

/// A cutter in its holder [mm], heights above its tip.
struct Tool {
    double nose = 0.0;                                               ///< radius of the end: 0 = flat
    double half_angle = 0.0;                                         ///< of the flanks above the nose, to the axis [rad]
    double radius = 0.0;                                             ///< greatest, of the cutting part
    double flute = 0.0, shank = 0.0, stick_out = 0.0, holder = 0.0;  ///< flute and stick-out: lengths; shank and holder: radii
    /// Radius of the cutting part. @pre s >= 0
    [[nodiscard]] double radius_at(double s) const;
    /// Least height of the end at a distance from the axis. @pre r <= radius
    [[nodiscard]] double end_at(double r) const;
};

struct Clamp {
    bool round = false;  ///< about the rotary axis: `low`, `high` along X, `size[0]` its radius
    std::array<double, 2> x{}, y{};
    double top = 0.0;  ///< [mm]; of a round one its radius
};

/// What the comments state.
struct Setup {
    explicit Setup(const Program& program);
    [[nodiscard]] Stock stock(const Program& program, double cell_mm) const;

    std::map<int, Tool> tools;
    std::vector<Clamp> clamps;
    std::optional<std::array<double, 6>> box;    ///< x, y, z, each low and high
    std::optional<std::array<double, 3>> round;  ///< radius, low, high along X
    std::optional<std::array<double, 2>> board;  ///< its top and the depth to which it may be cut
    double rotary = 0.0;                         ///< sign; 0: three axes
};

/// How far tool (cutter, shank or holder) reaches into a clamp at a pose; 0: no contact [mm].
[[nodiscard]] double overlap(const Tool& tool, const Pose& pose, const Clamp& clamp);

}  // namespace fusee::toolpath::mill
