#include "pushed_roller.h"

#include <algorithm>
#include <cmath>
#include <functional>
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

constexpr double kNowhere = -std::numeric_limits<double>::infinity();

/// The roller's place against one point of the rim, as its path counts it.
using Place = std::function<double(const RimPoint&)>;

/// Its centre along the line of its slide [mm].
Place on_slide(const exchange::PartFile& part, double back) {
    return [along = turned(part.guide.direction, back), offset = part.guide.offset_mm, sign = part.torque_sign](const RimPoint& p) {
        const double beside = sign * (p.xy_mm[1] * along[0] - p.xy_mm[0] * along[1]) - offset;
        const double square = p.reach_mm * p.reach_mm - beside * beside;
        return square < 0.0 ? kNowhere : p.xy_mm[0] * along[0] + p.xy_mm[1] * along[1] + std::sqrt(square);
    };
}

/// The turn of its arm since cam angle 0 [rad], by the triangle of pivot, point and roller centre.
Place on_arm(const exchange::PartFile& part, double back) {
    const exchange::PartGuide& guide = part.guide;
    return [pivot = turned(guide.position_mm, back), start = turned(guide.direction, back), arm = guide.arm_mm,
            sense = guide.sense](const RimPoint& p) {
        const double x = p.xy_mm[0] - pivot[0], y = p.xy_mm[1] - pivot[1], away = std::hypot(x, y);
        const double cosine = (arm * arm + away * away - p.reach_mm * p.reach_mm) / (2.0 * arm * away);
        if (!(std::abs(cosine) <= 1.0)) return kNowhere;
        return sense * std::atan2(start[0] * y - start[1] * x, start[0] * x + start[1] * y) + std::acos(cosine);
    };
}

/// Travel of the spring since cam angle 0 with the roller in its place [mm].
double lift_at(double place, const exchange::PartGuide& guide) {
    if (guide.kind == "roller") return place - guide.start_mm;
    const double seat = std::hypot(guide.lever_mm, guide.spring_mm), angle = std::atan2(guide.spring_mm, guide.lever_mm) - place;
    return guide.spring_mm - std::sqrt(guide.lever_mm * guide.lever_mm + seat * seat - 2.0 * guide.lever_mm * seat * std::cos(angle));
}

/// The highest of the roller's places by each point of the rim. Between points the rim is interpolated by a parabola.
double highest(const Rim& rim, const exchange::PartFile& part, double angle) {
    const double back = -part.rotation_sign * angle;
    const Place place = part.guide.kind == "arm" ? on_arm(part, back) : on_slide(part, back);
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
        deviation.push_back(lift_at(highest(ordered, part, row.angle_rad), part.guide) - row.lift_mm);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double force = 1.0 + part.spring_rate * 1e-3 * deviation[i] / rows[i].load;
        arms.push_back((rows[i].arm_mm + slope_near(rows, deviation, i)) * force);
    }
    return arms;
}

}  // namespace fusee::readback
