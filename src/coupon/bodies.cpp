#include "fusee/coupon/bodies.h"

#include <algorithm>
#include <cmath>

#include "fusee/cam/cam.h"
#include "fusee/core/error.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/validity.h"
#include "fusee/spring/potential.h"

namespace fusee::coupon {

namespace {

constexpr double kRate = 1e3, kPreload = 10e-3;  // [N/m], [m]: of any linear spring

/// F = k r (y0 + r theta): the torque of an arm r on a linear spring, so that table 1 of docs/theory/cams.md gives r' = 0.
core::Outcome<spring::SpringLawPtr> constant_arm_law(double arm, double travel) {
    const double start = kRate * arm * kPreload, rate = kRate * arm * arm;
    const spring::PotentialPtr linear = spring::make_polynomial({start, rate});
    return spring::make_pair_law(linear, linear, 2.0 * start, 2.0 * (start + rate * travel));  // loads are of both springs
}

cam::CamOptions cam_options(const CouponOptions& o) {
    cam::CamOptions options;
    options.cable_diameter = o.cable_diameter;
    options.torque_sign = -1;  // the wound end is the upper one, so that the anchor hole leads upwards and crosses no other turn
    options.path.kind = cam::PathKind::kHelix;
    const auto section = solid::groove_section(o.groove, o.cable_diameter, o.chordal_error);
    const double width = core::m_from_mm(section.back().z_mm - section.front().z_mm);
    options.path.pitch = width + 1.05 * std::max(o.groove.rib, o.loaded_wall);
    return options;
}

/// The options of K_SE's part, but through the disc, and without the features of that part only.
solid::PartOptions part_options(const CouponOptions& o) {
    solid::PartOptions options;
    options.groove = o.groove;
    options.hub = o.hub;
    options.hub.kind = solid::HubKind::kThrough;
    if (options.hub.lock != solid::HubLock::kSetScrew) options.hub.boss_height = 0.0;
    options.features.anchor_hole_diameter = std::max(2e-3, 1.5 * o.cable_diameter);
    options.chordal_error = o.chordal_error;
    return options;
}

using core::mm_from_m;

constexpr double kLeastWall_mm = 3.0, kLeastNotch_mm = 0.8, kNotchDepth_mm = 0.6;
constexpr double kPlate_mm = 5.0, kTower_mm = 25.0;
constexpr double kInset_mm = 1.0;    // of the tower: none of its walls coincides with one of the plate's
constexpr double kThrough_mm = 1.0;  // cutters extend this far beyond the plate

/// Places on the arm along x; the arm along y is plain.
struct Layout {
    double wall, widest, notch, width, pitch, length;

    explicit Layout(const CouponOptions& o)
        : wall(std::max(kLeastWall_mm, 2.0 * mm_from_m(o.loaded_wall))),
          widest(mm_from_m(o.hub.bore_diameter + o.clearance.high)),
          notch(std::max(kLeastNotch_mm, mm_from_m(o.detail))),
          width(std::ceil(widest + 3.0 * wall)),
          pitch(std::ceil(std::max(widest + wall, 2.0 * notch * o.holes))),
          length(width + pitch * o.holes) {}
    [[nodiscard]] double hole_x(int i) const { return width + pitch * (i + 0.5); }
    [[nodiscard]] double hole_y() const { return wall + 0.5 * widest; }
    /// The notches are in the strip beside the holes.
    [[nodiscard]] core::Range notch_y() const { return {widest + 1.5 * wall, widest + 2.25 * wall}; }
};

solid::Ring rectangle(core::Range x, core::Range y) { return {{x.low, y.low}, {x.high, y.low}, {x.high, y.high}, {x.low, y.high}}; }

solid::Mesh body(const Layout& at) {
    const double l = at.length, w = at.width;
    const solid::Ring ell{{0.0, 0.0}, {l, 0.0}, {l, w}, {w, w}, {w, l}, {0.0, l}};
    const core::Range inside{kInset_mm, w - kInset_mm};
    const solid::Ring tower = rectangle(inside, inside);
    solid::Mesh mesh;
    const solid::VertexRing bottom = solid::add_ring(mesh, ell, 0.0), top = solid::add_ring(mesh, ell, kPlate_mm);
    const solid::VertexRing foot = solid::add_ring(mesh, tower, kPlate_mm), head = solid::add_ring(mesh, tower, kTower_mm);
    solid::fill_face(mesh, bottom, {}, false);
    solid::add_wall_between(mesh, bottom, top, true);
    solid::fill_face(mesh, top, {foot}, true);
    solid::add_wall_between(mesh, foot, head, true);
    solid::fill_face(mesh, head, {}, true);
    return mesh;
}

void add(solid::Mesh& to, const solid::Mesh& more) {
    const auto first = static_cast<std::uint32_t>(to.points_mm.size());
    to.points_mm.insert(to.points_mm.end(), more.points_mm.begin(), more.points_mm.end());
    for (const solid::Triangle& t : more.triangles) to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

void validate(const CouponOptions& o) {
    core::require_positive("k_se.hub.bore_mm", mm_from_m(o.hub.bore_diameter), "mm");
    core::require_within("holes", o.holes, 2, 9);
    core::require_within("clearance.high", mm_from_m(o.clearance.high), mm_from_m(o.clearance.low) + 0.01, 5.0, "mm");
}

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

core::Outcome<Disc> make_disc(const CouponOptions& options) {
    core::require_within("disc_turns", options.disc_turns, 0.5, 10.0);
    Disc disc;
    disc.floor_mm = floor_mm(options);
    disc.spring = {.kind = spring::BaseKind::kCompression, .rate = kRate, .preload = kPreload};
    const double arm = core::m_from_mm(disc.floor_mm) + 0.5 * options.cable_diameter;
    const auto law = constant_arm_law(arm, 2.0 * core::kPi * options.disc_turns);
    if (!law) return law.refusal();
    const auto cam = cam::synthesize_cam({cam::PartKind::kParallel, *law, disc.spring, 1.0}, cam_options(options));
    if (!cam) return cam.refusal();
    auto part = solid::build_part(*cam, part_options(options));
    if (!part) return part.refusal();
    disc.part = std::move(part).value();
    return disc;
}

core::Outcome<solid::Mesh> finished(solid::Mesh mesh, const char* name) {
    solid::round_to_file(mesh);
    const solid::Validity validity = solid::validate(mesh);
    if (validity.good()) return mesh;
    core::Finding f =
        core::error_finding("coupon.validity", "the solid is not valid: " + validity.line(), 0.0, core::Bound::kAtLeast, 1.0, "");
    f.where = name;
    f.suggestion = "another bore or groove";
    f.source = "CGAL: closed, oriented, one component, no self-intersection";
    return f;
}

core::Outcome<Plate> make_plate(const CouponOptions& options) {
    validate(options);
    const Layout at(options);
    Plate plate;
    plate.length_mm = at.length;
    plate.width_mm = at.width;
    plate.plate_mm = kPlate_mm;
    plate.tower_mm = kTower_mm;
    solid::Mesh tools;  // apart from each other: one Boolean for all
    for (int i = 0; i < options.holes; ++i) {
        const double clearance = std::lerp(options.clearance.low, options.clearance.high, static_cast<double>(i) / (options.holes - 1));
        const double bore = mm_from_m(options.hub.bore_diameter + clearance);
        plate.bores_mm.push_back(bore);
        const solid::Outline hole = solid::circle(0.5 * bore, {at.hole_x(i), at.hole_y()});
        add(tools, solid::prism(solid::ring_of(hole, mm_from_m(options.chordal_error)), -kThrough_mm, kPlate_mm + kThrough_mm));
        for (int notch = 0; notch < i; ++notch) {  // side by side about the hole's middle, one width apart
            const double x = at.hole_x(i) + at.notch * (2.0 * notch - i + 0.5);
            add(tools, solid::prism(rectangle({x, x + at.notch}, at.notch_y()), kPlate_mm - kNotchDepth_mm, kPlate_mm + kThrough_mm));
        }
    }
    auto cut = solid::cut(body(at), {tools});
    auto mesh = finished(cut ? std::move(*cut) : solid::Mesh{}, "plate");
    if (!mesh) return mesh.refusal();
    plate.mesh = std::move(mesh).value();
    return plate;
}

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
