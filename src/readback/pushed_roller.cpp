#include "pushed_roller.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fusee::readback {

namespace {

constexpr double kHalfWindow = 0.1;  // [rad] to each side, for the mean slope
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A point of the rim with the distance of the roller's centre (a print's beads have a half width).
struct RimPoint {
    Point xy_mm{};
    double azimuth = 0.0, reach_mm = 0.0;
};
using Rim = std::vector<RimPoint>;

/// The rim's points in order around the axis.
Rim rim_of(const Floor& floor, double radius_mm) {
    Rim rim;
    for (std::size_t i = 0; i < floor.points.size(); ++i) {
        const Point& p = floor.points[i].xy_mm;
        rim.push_back({p, std::atan2(p[1], p[0]), radius_mm + (floor.reach_mm.empty() ? 0.0 : floor.reach_mm[i])});
    }
    std::sort(rim.begin(), rim.end(), [](const RimPoint& a, const RimPoint& b) { return a.azimuth < b.azimuth; });
    const auto same = [](const RimPoint& a, const RimPoint& b) { return b.azimuth - a.azimuth < 1e-9; };
    rim.erase(std::unique(rim.begin(), rim.end(), same), rim.end());
    return rim;
}

/// Top of the parabola through three points, whose middle one is the highest.
double top(const std::array<double, 3>& x, const std::array<double, 3>& y) {
    const double left = (y[1] - y[0]) / (x[1] - x[0]), right = (y[2] - y[1]) / (x[2] - x[1]), curvature = (right - left) / (x[2] - x[0]);
    if (!(curvature < 0.0)) return y[1];
    const double slope = left + curvature * (x[1] - x[0]);  // at the middle point
    return y[1] - slope * slope / (4.0 * curvature);
}

/// The highest of the roller's places by each point of the rim. Between points the rim is interpolated by a parabola.
double highest(const Rim& rim, const exchange::PartFile& part, double angle) {
    const exchange::PartGuide& guide = part.guide;
    const double back = -part.rotation_sign * angle, c = std::cos(back), s = std::sin(back);
    const Point along{c * guide.direction[0] - s * guide.direction[1], s * guide.direction[0] + c * guide.direction[1]};
    const auto place = [&](const RimPoint& p) {
        const double beside = part.torque_sign * (p.xy_mm[1] * along[0] - p.xy_mm[0] * along[1]) - guide.offset_mm;
        const double square = p.reach_mm * p.reach_mm - beside * beside;
        return square < 0.0 ? -std::numeric_limits<double>::infinity() : p.xy_mm[0] * along[0] + p.xy_mm[1] * along[1] + std::sqrt(square);
    };
    const auto best = std::max_element(rim.begin(), rim.end(), [&](const RimPoint& a, const RimPoint& b) { return place(a) < place(b); });
    if (best == rim.end() || std::isinf(place(*best))) return kNaN;
    const std::size_t count = rim.size(), i = static_cast<std::size_t>(best - rim.begin());
    const RimPoint &before = rim[(i + count - 1) % count], &after = rim[(i + 1) % count];
    const auto apart = [&](const RimPoint& p) { return std::hypot(p.xy_mm[0] - best->xy_mm[0], p.xy_mm[1] - best->xy_mm[1]); };
    const double low = place(before), high = place(after);
    return std::isinf(low) || std::isinf(high) ? place(*best) : top({-apart(before), 0.0, apart(after)}, {low, place(*best), high});
}

/// Least-squares slope of the deviations over the rows within the window.
double slope_near(const std::vector<exchange::TargetRow>& rows, const std::vector<double>& deviation, std::size_t i) {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double away = rows[k].angle_rad - rows[i].angle_rad;
        if (std::abs(away) > kHalfWindow) continue;
        n += 1.0, x += away, y += deviation[k], xx += away * away, xy += away * deviation[k];
    }
    const double spread = n * xx - x * x;
    return spread > 0.0 ? (n * xy - x * y) / spread : kNaN;
}

}  // namespace

std::vector<double> pushed_arms(const Floor& rim, const exchange::PartFile& part) {
    const Rim ordered = rim_of(rim, part.guide.radius_mm);
    const std::vector<exchange::TargetRow>& rows = part.target;
    std::vector<double> deviation, arms;
    for (const exchange::TargetRow& row : rows)
        deviation.push_back(highest(ordered, part, row.angle_rad) - part.guide.start_mm - row.lift_mm);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double force = 1.0 + part.spring_rate * 1e-3 * deviation[i] / rows[i].load;
        arms.push_back((rows[i].arm_mm + slope_near(rows, deviation, i)) * force);
    }
    return arms;
}

}  // namespace fusee::readback
