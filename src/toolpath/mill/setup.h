#pragma once
#include <map>
#include <optional>
#include <vector>

#include "fusee/toolpath/mill.h"

namespace fusee::toolpath::mill {

/// Of the angle between a cutter's flanks and its axis; kept, since each cell of the stock asks for them.
struct Slant {
    double sine = 0.0, cosine = 1.0, tangent = 0.0;
};

/// A cutter in its holder [mm], heights above its tip.
struct Tool {
    double nose = 0.0;                                               ///< radius of the end: 0 = flat
    Slant flank;                                                     ///< above the nose
    double tip = 0.0, lead = 0.0;                                    ///< a drill's point, a reamer's lead: radius at the end, length
    double radius = 0.0;                                             ///< greatest, of the cutting part
    double flute = 0.0, shank = 0.0, stick_out = 0.0, holder = 0.0;  ///< flute and stick-out: lengths; shank and holder: radii
    /// Radius of the cutting part. @pre s >= 0
    [[nodiscard]] double radius_at(double s) const;
    /// Least height of the end at a distance from the axis. @pre r <= radius
    [[nodiscard]] double end_at(double r) const;
};

/// A round place in a plate, from the stock's top down to `bottom`.
struct Hole {
    std::size_t line = 0;
    double x = 0.0, y = 0.0, radius = 0.0, bottom = 0.0;
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
    std::vector<Hole> holes;                     ///< that the program makes
    std::vector<Hole> index;                     ///< that the blank brings, by which A is set, in the body frame
    bool index_stated = false;                   ///< also "index none", by hand
    std::optional<double> index_a;               ///< where the index is to the side of +Y, at the axis's height [deg]
    std::vector<Clamp> held;                     ///< where the stock stands fast, from above; clamps do so too
};

/// Faults of the stock at the program's end: "millsim.hole", a hole that is not at its full diameter to its bottom, and "millsim.free", a
/// piece of more than 1 mm2 that no clamp and no tab holds.
[[nodiscard]] std::vector<Contact> faults_of(const Setup& setup, const Stock& stock, const Program& program);
/// "millsim.index": a rotary program whose blank does not bring the hole by which A is set, or that states another A for it.
[[nodiscard]] std::vector<Contact> index_faults(const Setup& setup, const Stock& blank);

/// How far tool (cutter, shank or holder) reaches into a clamp at a pose; 0: no contact [mm].
[[nodiscard]] double overlap(const Tool& tool, const Pose& pose, const Clamp& clamp);

}  // namespace fusee::toolpath::mill
