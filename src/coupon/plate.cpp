#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/coupon/bodies.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/outline.h"
#include "fusee/solid/validity.h"

namespace fusee::coupon {

namespace {

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

}  // namespace

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

}  // namespace fusee::coupon
