#include "checks/known_bad.h"

// A roller of 8 mm radius on a disc of 20 mm whose law starts at psi = 0: known by hand.
namespace fusee::checks {

namespace {

/// A printed roller cam of constant lift: r = 6 mm all along, s from 28 mm, on steel rules for pressure.
Fixture rim() {
    Fixture b = helix(20.0 * kMm, 4.0 * kMm);
    cam::Cam& cam = b.part.cam;
    cam.options.family = cam::Family::kRoller;
    cam.options.path.kind = cam::PathKind::kPlanar;
    cam.options.roller.radius = 8.0 * kMm;
    cam.options.roller.base_radius = 20.0 * kMm;
    cam.options.roller.width = 5.0 * kMm;
    cam.options.roller.contact_modulus = 2e9;
    cam.options.roller.max_pressure = 100e6;
    cam.options.cable_diameter = 0.0;
    b.cable.max_pressure = 200e6;  // a long arm loads the key
    cam.path = [](double psi) { return cam::PathPoint{psi, 20.0 * kMm, 0.0, 20.0 * kMm, 0.0}; };
    cam.groove_psi = {0.0, 2.0 * core::kPi};
    work(b, 0.0, 3.0, 20.0 * kMm);
    for (cam::Contact& c : cam.working) {
        c.arm.arm = 6.0 * kMm;
        c.arm.slope = 0.0;
        c.arm.tension = b.spring.rate * c.arm.state;
        c.arm.travel = c.arm.state - b.spring.preload;
    }
    b.part.options.rim_width = 8.0 * kMm;
    b.part.section = {{0.0, -3.0}, {0.0, 0.0}, {0.0, 3.0}};
    b.part.z_low = -4.0 * kMm;
    b.part.z_high = 4.0 * kMm;
    return b;
}

/// The same on an arm of 60 mm, at the first place at a right angle to the line from the axis, its spring at the roller: q is the arm.
Fixture on_arm() {
    Fixture b = rim();
    b.part.cam.options.roller.follower = cam::FollowerKind::kArm;
    b.spring.preload *= 0.65;  // between pins it buckles earlier
    for (cam::Contact& c : b.part.cam.working) {
        c.arm.state *= 0.65;
        c.arm.tension = b.spring.rate * c.arm.state;
        c.arm.travel = c.arm.state - b.spring.preload;
    }
    b.part.cam.options.roller.arm = {
        .length = 60.0 * kMm, .pivot = std::hypot(60.0, 28.0) * kMm, .side = 1, .lever = 60.0 * kMm, .spring = 60.0 * kMm};
    return b;
}

}  // namespace

std::vector<Case> roller_cases() {
    const auto first = [](Fixture& b) -> cam::ArmPoint& { return b.part.cam.working.front().arm; };
    return {
        // tan phi = (30 - 0)/28 at the first place
        {"roller.pressure_angle", "an arm longer than the travel", rim, [=](Fixture& b) { first(b).arm = 30.0 * kMm; }, kRequired,
         core::deg_from_rad(std::atan(30.0 / 28.0)), 35.0},
        {"roller.pressure_angle", "steep", rim, [=](Fixture& b) { first(b).arm = 18.0 * kMm; }, kReview,
         core::deg_from_rad(std::atan(18.0 / 28.0)), 30.0},
        // tan phi = (q - e)/s there: s = 28, e = 0
        {"roller.pressure_angle", "steep on an arm", on_arm, [=](Fixture& b) { first(b).arm = 22.0 * kMm; }, kReview,
         core::deg_from_rad(std::atan(22.0 / 28.0)), 35.0},
        {"roller.pressure_angle", "too steep on an arm", on_arm, [=](Fixture& b) { first(b).arm = 30.0 * kMm; }, kRequired,
         core::deg_from_rad(std::atan(30.0 / 28.0)), 45.0},
        // the rim's radius at one place, 0.4 and 3 mm, and the roller's 8
        {"roller.undercut", "nearly a cusp", rim, [](Fixture& b) { b.part.cam.working[7].path.rho = 0.4 * kMm; }, kRequired, 1.05, 1.1},
        {"roller.undercut", "sharp", rim, [](Fixture& b) { b.part.cam.working[7].path.rho = 3.0 * kMm; }, kReview, 1.375, 2.0},
        {"roller.rim_width", "a roller wider than its rim", rim, [](Fixture& b) { b.part.cam.options.roller.width = 6.5 * kMm; }, kRequired,
         6.0, 6.5},
        // 0.5 mm of 20 mm
        {"roller.lift_off", "nearly no preload", rim, [=](Fixture& b) { first(b).tension = b.spring.rate * 0.5 * kMm; }, kReview, 2.5, 5.0},
        // N = k 20 mm/cos phi at the last place, where rho_pitch = L^3/(L^2 + 36): 3 kinds of length in mm, E* in MPa
        {"roller.contact_pressure", "plastics that allow 30 MPa", rim, [](Fixture& b) { b.part.cam.options.roller.max_pressure = 30e6; },
         kRequired,
         [] {
             const double s = 38.0, squared = s * s + 36.0, length = std::sqrt(squared), rho = length * squared / (squared + 36.0) - 8.0;
             return std::sqrt(7.46 * 20.0 * length / s * 2000.0 / (core::kPi * 5.0) * (1.0 / 8.0 + 1.0 / rho));
         }(),
         30.0},
    };
}

}  // namespace fusee::checks
