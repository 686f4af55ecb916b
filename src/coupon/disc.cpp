#include "fusee/cam/cam.h"
#include "fusee/core/error.h"
#include "fusee/coupon/bodies.h"
#include "fusee/solid/part.h"
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

}  // namespace fusee::coupon
