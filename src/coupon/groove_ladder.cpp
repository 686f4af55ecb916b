#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/coupon/bodies.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/outline.h"

namespace fusee::coupon {

namespace {

using core::mm_from_m;

constexpr double kRatios[] = {0.50, 0.53, 0.56, 0.60, 0.65, 0.70};
constexpr double kFoot_mm = 3.0;         // height and overhang
constexpr double kAroundShaft_mm = 4.0;  // from the bore to the deepest floor, key included
constexpr double kLeastFloor_mm = 15.0;
constexpr double kLeastFlank = 0.01;  // of a cable, above a half-circle floor: all grooves have the same depth
constexpr double kSlide_mm = 0.4;     // a hand holds the ladder on the shaft

std::vector<double> ratios(double own) {
    std::vector<double> all(std::begin(kRatios), std::end(kRatios));
    const auto near = [own](double ratio) { return std::abs(ratio - own) < 1e-9; };
    if (std::none_of(all.begin(), all.end(), near)) all.push_back(own);
    std::sort(all.begin(), all.end());
    return all;
}

/// A point of the outer contour, turned about the axis.
struct ContourPoint {
    double radius, z;
};

/// A body of revolution with a plain bore: one ring of vertices for each point of the contour, bottom to top.
solid::Mesh revolved(const std::vector<ContourPoint>& contour, double bore_radius, double tolerance_mm) {
    double widest = 0.0;
    for (const ContourPoint& p : contour) widest = std::max(widest, p.radius);
    const solid::Ring round = solid::ring_of(solid::circle(widest), tolerance_mm);
    const auto scaled = [&](double radius) {
        solid::Ring ring = round;
        for (solid::Point2& p : ring)
            for (double& coordinate : p) coordinate *= radius / widest;
        return ring;
    };
    solid::Mesh mesh;
    std::vector<solid::VertexRing> rings;
    for (const ContourPoint& p : contour) rings.push_back(solid::add_ring(mesh, scaled(p.radius), p.z));
    for (std::size_t i = 0; i + 1 < rings.size(); ++i) solid::add_wall_between(mesh, rings[i], rings[i + 1], true);
    const solid::VertexRing low = solid::add_ring(mesh, scaled(bore_radius), contour.front().z);
    const solid::VertexRing high = solid::add_ring(mesh, scaled(bore_radius), contour.back().z);
    solid::fill_face(mesh, rings.front(), {low}, false);
    solid::add_wall_between(mesh, low, high, false);
    solid::fill_face(mesh, rings.back(), {high}, true);
    return mesh;
}

}  // namespace

double floor_mm(const CouponOptions& options) {
    return std::ceil(std::max(kLeastFloor_mm, solid::bore_reach_mm(options.hub) + kAroundShaft_mm));
}

core::Outcome<GrooveLadder> make_groove_ladder(const CouponOptions& options) {
    const double d = mm_from_m(options.cable_diameter), floor = floor_mm(options),
                 rib = mm_from_m(std::max(options.groove.rib, options.loaded_wall));
    GrooveLadder ladder;
    ladder.ratios = ratios(options.groove.radius_ratio);
    solid::GrooveOptions groove = options.groove;
    groove.depth_ratio = std::max(groove.depth_ratio, ladder.ratios.back() + kLeastFlank);
    const double lip = floor + d * groove.depth_ratio;
    std::vector<ContourPoint> contour{{lip + kFoot_mm, 0.0}, {lip + kFoot_mm, kFoot_mm}, {lip, kFoot_mm}};
    for (const double ratio : ladder.ratios) {
        groove.radius_ratio = ratio;
        const std::vector<solid::SectionPoint> section = solid::groove_section(groove, options.cable_diameter, 0.5 * options.chordal_error);
        ladder.z_mm.push_back(contour.back().z + rib - section.front().z_mm);
        for (const solid::SectionPoint& p : section) contour.push_back({floor + 0.5 * d + p.offset_mm, ladder.z_mm.back() + p.z_mm});
    }
    contour.push_back({lip, contour.back().z + rib});
    const double bore = 0.5 * (mm_from_m(options.hub.bore_diameter) + kSlide_mm);
    auto mesh = finished(revolved(contour, bore, 0.5 * mm_from_m(options.chordal_error)), "groove_ladder");
    if (!mesh) return mesh.refusal();
    ladder.mesh = std::move(mesh).value();
    return ladder;
}

}  // namespace fusee::coupon
