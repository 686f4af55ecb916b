#include "columns.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/outline.h"

namespace fusee::solid {

namespace {

constexpr double kTurn = 2.0 * core::kPi;
constexpr double kWidestStep = 0.12;   // [rad] between columns however small the radius: a round part looks round
constexpr double kProud = 0.3;         // [mm] that a flange widened by a boss stands beyond the lips everywhere: no sliver faces

Vec3 section_vertex(const cam::PathPoint& path, const SectionPoint& s) {
    const OutlinePoint p = flange_point(path, s.offset_mm, 0.0);
    return {p.point[0], p.point[1], core::mm_from_m(path.z) + s.z_mm};
}

}  // namespace

ColumnMaker::ColumnMaker(const cam::Cam& cam, const std::vector<SectionPoint>& section, const Flanges& flanges)
    : cam_(cam), section_(section), flanges_(flanges), lip_(section.front().offset_mm), half_width_(section.back().z_mm) {
    const core::Range psi = cam.groove_psi;
    double lowest = 0.0, highest = 0.0, farthest = 0.0;
    if (!cam.closed()) {
        lowest = std::min(core::mm_from_m(cam.path(psi.low).z), core::mm_from_m(cam.path(psi.high).z));
        highest = std::max(core::mm_from_m(cam.path(psi.low).z), core::mm_from_m(cam.path(psi.high).z));
        for (double a = psi.low; a <= psi.high; a += 0.01) {
            const OutlinePoint lip = flange_point(cam.path(a), lip_, 0.0);
            farthest = std::max(farthest, std::hypot(lip.point[0], lip.point[1]));
        }
        circle_ = std::max(farthest + std::max(flanges.height_mm, kProud), flanges.core_radius_mm);
    }
    z_low_ = lowest - half_width_ - flanges.rib_mm;
    z_high_ = highest + half_width_ + flanges.rib_mm;
}

int ColumnMaker::turns_at(double u) const { return 1 + static_cast<int>(std::floor((cam_.groove_psi.high - u) / kTurn)); }

ColumnPoints ColumnMaker::at(double u, int turns) const {
    ColumnPoints column;
    if (cam_.closed()) {
        const cam::PathPoint path = cam_.path(u);
        const auto rails = [&](double z_outer, double z_lip, double core_radius) {
            const double proud = std::max(flanges_.height_mm, core_radius > 0.0 ? kProud : 0.0);
            const OutlinePoint p = flange_point(path, lip_ + proud, core_radius);
            std::vector<Vec3> points{{p.point[0], p.point[1], z_outer}};
            if (proud > 0.0) points.push_back({p.point[0], p.point[1], z_lip});
            return points;
        };
        column.lower = rails(z_low_, -half_width_, flanges_.core_radius_mm);
        column.upper = rails(z_high_, half_width_, 0.0);
        std::reverse(column.upper.begin(), column.upper.end());
    } else {
        const double x = circle_ * std::cos(u), y = circle_ * std::sin(u);
        column.lower = {{x, y, z_low_}, {x, y, z_low_ + flanges_.rib_mm}};
        column.upper = {{x, y, z_high_ - flanges_.rib_mm}, {x, y, z_high_}};
    }
    for (int j = 0; j < turns; ++j) {
        const cam::PathPoint path = cam_.path(u + kTurn * j);
        std::vector<Vec3>& slot = column.slots.emplace_back();
        for (const SectionPoint& s : section_) slot.push_back(section_vertex(path, s));
    }
    return column;
}

double ColumnMaker::flattest_mm(double u) const {
    double flattest = circle_;
    for (int j = 0; j < std::max(1, turns_at(u)); ++j) {
        const cam::PathPoint path = cam_.path(u + kTurn * j);
        flattest = std::max(flattest, core::mm_from_m(path.rho) + lip_ + flanges_.height_mm);
        if (cam_.closed()) flattest = std::max(flattest, flange_point(path, lip_ + flanges_.height_mm, flanges_.core_radius_mm).rho);
    }
    return flattest;
}

std::vector<double> place_columns(const ColumnMaker& maker, double low, double high, double tolerance_mm) {
    const auto step_at = [&](double u) { return std::min(kWidestStep, std::sqrt(8.0 * tolerance_mm / maker.flattest_mm(u))); };
    // Columns wanted so far, as a running integral of 1/step; columns then stand at equal shares of it.
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
