#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/sweep.h"

namespace fusee::solid {

namespace {

using core::kTurn;
constexpr double kWidestStep = 0.12;  // [rad] between columns at any radius: a round part looks round
constexpr double kProud_mm = 0.3;     // least height above the lips of a flange widened by a boss, or of a helix's: no sliver faces
constexpr double kBossRim_mm = 1.0;   // the lower flange extends this far beyond a boss
constexpr double kSpare = 1.5;        // run-outs exceed the need of their lips by this factor

}  // namespace

Flanges flanges_of(const PartOptions& options) {
    const double height = core::mm_from_m(options.flange_height);
    if (options.hub.boss_height <= 0.0) return {height, height, core::mm_from_m(options.groove.rib), 0.0};
    return {std::max(height, kProud_mm), height, core::mm_from_m(options.groove.rib),
            core::mm_from_m(0.5 * options.hub.boss_diameter) + kBossRim_mm};
}

ColumnMaker::ColumnMaker(const cam::Cam& cam, const std::vector<SectionPoint>& section, const Flanges& flanges)
    : cam_(cam),
      section_(section),
      flanges_(flanges),
      lip_(section.front().offset_mm),
      half_width_(section.back().z_mm),
      reach_(cam.groove_psi) {
    z_low_ = -half_width_ - flanges.rib_mm;
    z_high_ = half_width_ + flanges.rib_mm;
    if (!cam.closed()) measure_helix();
}

void ColumnMaker::measure_helix() {
    const core::Range groove = reach_;
    const auto farthest_lip = [&] {
        double farthest = 0.0;
        for (double a = reach_.low; a <= reach_.high; a += 0.01) {
            const OutlinePoint lip = flange_point(cam_.path(a), lip_, 0.0);
            farthest = std::max(farthest, std::hypot(lip.point[0], lip.point[1]));
        }
        return farthest;
    };
    const double farthest = farthest_lip();
    const auto first_width = [&](double psi) {
        const cam::PathPoint p = cam_.path(psi);
        return std::clamp(kSpare * std::abs(p.slope) * core::m_from_mm(farthest) / (p.h * p.rho), 0.35, 2.0);
    };
    double low = first_width(groove.low), high = first_width(groove.high);
    // The run-out has a larger radius than the groove. If its lips would turn back, it is computed again with a larger width.
    for (bool enough = false; !enough;) {
        reach_ = {groove.low - low, groove.high + high};
        circle_ = std::max(farthest_lip() + std::max(flanges_.upper_height_mm, kProud_mm), flanges_.core_radius_mm);
        const auto lengthened = [](double width, const RunOut& need) {
            return need.land > width ? std::clamp(kSpare * need.land, width, kLongestRunOut) : width;
        };
        const double longer_low = lengthened(low, run_out_needed(false)), longer_high = lengthened(high, run_out_needed(true));
        enough = longer_low == low && longer_high == high;
        low = longer_low, high = longer_high;
    }
    const double z0 = core::mm_from_m(cam_.path(reach_.low).z), z1 = core::mm_from_m(cam_.path(reach_.high).z);
    z_low_ += std::min(z0, z1);
    z_high_ += std::max(z0, z1);
}

namespace {

/// A lip in the run-out: (1 - s) L + s E, with L = f n + f' t on the contour's parallel, E = R n on the flange's edge and s the covered
/// share of the run-out. `slope` is positive outward along the run-out. [mm]
struct Leaving {
    double f, slope, rho, share, edge;

    [[nodiscard]] double middle() const { return (1.0 - share) * f + share * edge; }
    /// Width of the whole run-out with which this lip keeps turning about a lip at a n + a' t; the axis is a lip at 0.
    [[nodiscard]] double needed_about(double a, double a_slope) const {
        const double out = middle() - a;
        return (slope * out + ((1.0 - share) * slope - a_slope) * (edge - f)) / (out * ((1.0 - share) * rho + share * edge));
    }
};

}  // namespace

ColumnMaker::RunOut ColumnMaker::run_out_needed(bool high) const {
    constexpr int kPlaces = 60;
    constexpr double kMostForLand =
        2.0;  // times the need of the axis: a lip that is slightly ahead of its normal passes its neighbour vertically
    constexpr double kBeside = 0.1;  // of its distance from the axis: a lip that is not farther out than its neighbour passes it vertically
    const core::Range& groove = cam_.groove_psi;
    const double sign = high ? 1.0 : -1.0, begin = high ? groove.high : groove.low;
    const double width = high ? reach_.high - groove.high : groove.low - reach_.low;
    const auto at_lip = [&](const cam::PathPoint& p) { return core::mm_from_m(p.h) + lip_; };
    RunOut need;
    for (int i = 0; i < kPlaces; ++i) {
        const double share = static_cast<double>(i) / kPlaces, psi = begin + sign * share * width, beside = psi - sign * kTurn;
        const cam::PathPoint p = cam_.path(psi);
        if (!reach_.holds(beside) || sign * p.slope <= 0.0) continue;
        const Leaving lip{at_lip(p), sign * core::mm_from_m(p.slope), core::mm_from_m(p.rho) + lip_, share, circle_};
        const double about_axis = lip.needed_about(0.0, 0.0);
        if (about_axis > need.width) need.width = about_axis, need.psi = psi;
        need.land = std::max(need.land, about_axis);
        if (!groove.holds(beside)) continue;
        const cam::PathPoint other = cam_.path(beside);
        if (lip.middle() - at_lip(other) > kBeside * lip.middle())
            need.land = std::max(need.land,
                                 std::min(kMostForLand * about_axis, lip.needed_about(at_lip(other), sign * core::mm_from_m(other.slope))));
    }
    return need;
}

std::vector<AngularSpan> ColumnMaker::spans() const {
    const double low = reach_.low;
    if (cam_.closed()) return {{low, low + kTurn, {true}}};
    const auto direction = [&](double psi) { return low + std::fmod(psi - low, kTurn); };
    std::vector<double> borders{low, direction(cam_.groove_psi.low), direction(cam_.groove_psi.high), direction(reach_.high), low + kTurn};
    std::sort(borders.begin(), borders.end());
    std::vector<AngularSpan> spans;
    for (std::size_t i = 1; i < borders.size(); ++i) {
        AngularSpan s{borders[i - 1], borders[i], {}};
        const double middle = 0.5 * (s.low + s.high);
        for (double psi = middle; psi < reach_.high; psi += kTurn) s.cut.push_back(cam_.groove_psi.holds(psi));
        if (s.high > s.low) spans.push_back(s);
    }
    return spans;
}

std::vector<Vec3> ColumnMaker::lower_rails(double u) const {
    if (!cam_.closed()) {
        const double x = circle_ * std::cos(u), y = circle_ * std::sin(u);
        return {{x, y, z_low_}, {x, y, z_low_ + flanges_.rib_mm}};
    }
    const OutlinePoint p = flange_point(cam_.path(u), lip_ + flanges_.lower_height_mm, flanges_.core_radius_mm);
    std::vector<Vec3> rails{{p.point[0], p.point[1], z_low_}};
    if (flanges_.lower_height_mm > 0.0) rails.push_back({p.point[0], p.point[1], -half_width_});
    return rails;
}

std::vector<Vec3> ColumnMaker::upper_rails(double u) const {
    if (!cam_.closed()) {
        const double x = circle_ * std::cos(u), y = circle_ * std::sin(u);
        return {{x, y, z_high_ - flanges_.rib_mm}, {x, y, z_high_}};
    }
    const OutlinePoint p = flange_point(cam_.path(u), lip_ + flanges_.upper_height_mm, 0.0);
    std::vector<Vec3> rails{{p.point[0], p.point[1], z_high_}};
    if (flanges_.upper_height_mm > 0.0) rails.insert(rails.begin(), {p.point[0], p.point[1], half_width_});
    return rails;
}

std::vector<Vec3> ColumnMaker::section_at(double psi) const {
    const cam::PathPoint path = cam_.path(psi);
    std::vector<Vec3> points;
    for (const SectionPoint& s : section_) {
        const OutlinePoint p = flange_point(path, s.offset_mm, 0.0);
        points.push_back({p.point[0], p.point[1], core::mm_from_m(path.z) + s.z_mm});
    }
    return points;
}

ColumnMaker::Lips ColumnMaker::run_out(double psi) const {
    const core::Range& groove = cam_.groove_psi;
    const bool below = psi < 0.5 * (groove.low + groove.high);
    const double share = below ? (groove.low - psi) / (groove.low - reach_.low) : (psi - groove.high) / (reach_.high - groove.high);
    const std::vector<Vec3> section = section_at(psi);
    const Vec3 edge = below ? lower_rails(psi).back() : upper_rails(psi).front();
    const auto towards_edge = [&](const Vec3& lip) {
        Vec3 p{};
        for (std::size_t i = 0; i < 3; ++i) p[i] = lip[i] + share * (edge[i] - lip[i]);
        return p;
    };
    return {towards_edge(section.front()), towards_edge(section.back()), share > 1.0 - 1e-9};
}

double ColumnMaker::flattest_mm(double u) const {
    if (cam_.closed()) {
        const cam::PathPoint path = cam_.path(u);
        return std::max({core::mm_from_m(path.rho) + lip_ + flanges_.upper_height_mm,
                         flange_point(path, lip_ + flanges_.lower_height_mm, flanges_.core_radius_mm).rho});
    }
    double flattest = circle_;
    for (double psi = u; psi <= reach_.high; psi += kTurn) flattest = std::max(flattest, core::mm_from_m(cam_.path(psi).rho) + lip_);
    return flattest;
}

std::vector<Point2> upper_outline(const Part& part) {
    const ColumnMaker maker(part.cam, part.section, flanges_of(part.options));
    std::vector<Point2> outline;
    for (const double psi : part.columns_psi) {
        const Vec3 p = maker.upper_rails(psi).back();
        outline.push_back({p[0], p[1]});
    }
    return outline;
}

double helix_radius_mm(const Part& part) { return ColumnMaker(part.cam, part.section, flanges_of(part.options)).helix_radius_mm(); }

double crossing_at_zero(const std::vector<Point2>& ring, double sign) {
    double far = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        if ((a[1] <= 0.0) == (b[1] <= 0.0)) continue;
        far = std::max(far, sign * (a[0] + (b[0] - a[0]) * (-a[1]) / (b[1] - a[1])));
    }
    return far;
}

std::vector<double> place_columns(const ColumnMaker& maker, double low, double high, double tolerance_mm) {
    const auto step_at = [&](double u) { return std::min(kWidestStep, std::sqrt(8.0 * tolerance_mm / maker.flattest_mm(u))); };
    // Number of columns so far, as a running integral of 1/step; columns are then placed at equal shares of it.
    std::vector<double> place{low}, wanted{0.0};
    double step = step_at(low);
    while (place.back() < high) {
        const double next = std::min(high, place.back() + std::min(4e-3, 0.5 * step));
        const double there = step_at(next);
        wanted.push_back(wanted.back() + (next - place.back()) / std::min(step, there));
        place.push_back(next);
        step = there;
    }
    const int count = static_cast<int>(std::ceil(wanted.back()));
    std::vector<double> columns{low};
    std::size_t at = 1;
    for (int i = 1; i < count; ++i) {
        const double share = wanted.back() * i / count;
        while (wanted[at] < share) ++at;
        columns.push_back(place[at - 1] + (place[at] - place[at - 1]) * (share - wanted[at - 1]) / (wanted[at] - wanted[at - 1]));
    }
    columns.push_back(high);
    return columns;
}

}  // namespace fusee::solid
