#include "checks/known_bad.h"

namespace fusee::checks {

namespace {

/// The stated turns, of a wire with which they have the rate.
void wind(Fixture& b, double turns) { b.spring.active_coils = turns, match_rate(b); }

void preload(Fixture& b, double angle) {
    b.spring.preload = angle;
    work(b, -kWorking, kWorking, 10.0);
}

}  // namespace

std::vector<Case> spring_cases() {
    return {
        {"spring.travel", "own limit", pusher, [](Fixture& b) { b.spring.max_state = 18 * kMm; }, kRequired, 20.0, 18.0},
        // 44 - 10 coils of 2 mm = 24 mm to solid
        {"spring.travel", "83 % of solid", pusher, [](Fixture& b) { b.spring.free_length = 44 * kMm; }, kReview, 20.0, 19.2},
        {"spring.travel",
         "solid",
         pusher,
         [](Fixture& b) { b.spring.free_length = 40 * kMm; },
         kRequired,
         20.0,
         17.0,
         1e-6,
         {"spring.coil_gap"}},
        // 26 mm to solid, 20 mm used; 8 (0.0015 x 32^2/2 + 0.2)
        {"spring.coil_gap", "wide coils", pusher,
         [](Fixture& b) {
             b.spring.coil_diameter = 32 * kMm, b.spring.free_length = 46 * kMm, b.spring.tensile_strength = 0.0, match_rate(b);
         },
         kReview, 6.0, 7.744},
        // the same of 22 mm: 8 (0.0015 x 22^2/2 + 0.2) = 4.504, and half as much more
        {"spring.coil_gap", "many cycles",
         [] {
             Fixture b = pusher();
             b.spring.coil_diameter = 22 * kMm, b.spring.free_length = 46 * kMm, b.spring.tensile_strength = 0.0, match_rate(b);
             return b;
         },
         [](Fixture& b) { b.spring.cycles = 1e5; }, kReview, 6.0, 6.756},
        {"spring.torsion_angle", "own limit", spool, [](Fixture& b) { b.spring.max_state = 8.0; }, kRequired, 10.0, 8.0},
        // 1.2 (10 + 1 + 10/(2 pi))
        {"spring.body_growth", "short space", spool, [](Fixture& b) { wind(b, 10), b.spring.free_length = 14 * kMm; }, kRequired, 15.109859,
         14.0},
        {"spring.unwinding", "hardly preloaded", spool, [](Fixture& b) { preload(b, 0.05); }, kReview, 0.05, 0.1},
        {"spring.hand", "right hand", spool, [](Fixture& b) { b.spring.hand = spring::Hand::kRight; }, kRequired, -1.0, 0.0},
        {"spring.load", "torque", spool, [](Fixture& b) { b.spring.max_load = 0.15; }, kRequired, 0.2, 0.15},
        {"spring.load", "force", pusher, [](Fixture& b) { b.spring.max_load = 140; }, kRequired, 149.2, 140.0},
        // w = 10, q = 10.07/9.25, M = 0.2 Nm
        {"spring.stress", "bending", spool, [](Fixture& b) { b.spring.tensile_strength = 1100e6; }, kRequired, 1283.4357, 770.0, 1e-4},
        // C = 8, K_W = 31/28 + 0.615/8, F = 149.2 N; 1500 * 0.8/sqrt 3
        {"spring.stress", "shear", pusher, [](Fixture& b) { b.spring.tensile_strength = 1500e6; }, kRequired, 899.6988917, 692.820323,
         1e-4},
        // from 0.08 to 0.2 Nm: amplitude 385.03 of 500/(1 - 500/2000) MPa, mean 898.40 of 2000
        {"spring.fatigue", "bending", spool, [](Fixture& b) { b.spring.cycles = 1e6; }, kRequired, 0.9739483, 1.0},
        // from 74.6 to 149.2 N: amplitude 224.92 of 300/(1 - 300/1340) MPa, mean 674.77 of 1340
        {"spring.fatigue", "shear", pusher, [](Fixture& b) { b.spring.cycles = 1e8; }, kRequired, 0.9212704, 1.0},
        // 0.4271616 N m^2/(64 x 12 mm x 20)
        {"spring.rate", "too few turns", spool, [](Fixture& b) { b.spring.active_coils = 20; }, kRequired, 39.05, 10.0, 1e-6},
        {"spring.rate", "few turns", spool, [](Fixture& b) { b.spring.active_coils = 26; }, kReview, 6.9615385, 5.0},
        // 81.5 GPa (2 mm)^4/(8 (16 mm)^3 8) = 4974.365 N/m
        {"spring.rate", "measured", spool,
         [](Fixture& b) { b.spring.active_coils = 20, b.spring.rate_origin = spring::RateOrigin::kMeasured; }, kReview, 39.05, 10.0, 1e-6},
        {"spring.rate", "compression", pusher, [](Fixture& b) { b.spring.shear_modulus = 81.5e9; }, kRequired, 33.3195, 10.0, 1e-4},
        // 0.5 sqrt(0.02 Nm/rad/(3.3470 g (6 mm)^2))
        {"spring.surge", "fast", spool, [](Fixture& b) { wind(b, 10), b.spring.motion = 12; }, kReview, 16.975631, 20.0},
        {"spring.surge", "too fast", spool, [](Fixture& b) { wind(b, 10), b.spring.motion = 20; }, kRequired, 10.185379, 13.0},
        // 33.333 N x (5 + 0.6 + 1) mm, w = 2 x 5/1.2 + 1
        {"spring.leg_bending", "wide bend", spool, [](Fixture& b) { b.spring.leg_bend_radius = 5 * kMm; }, kRequired, 1420.70, 1400.0, 0.1},
        {"spring.buckling", "slender", pusher, [](Fixture& b) { b.spring.free_length = 200 * kMm; }, kReview, 20.0, 14.9995030},
        {"spring.index", "tight coil", spool,
         [](Fixture& b) { without_slot(b), b.spring.coil_diameter = 4.2 * kMm, b.spring.tensile_strength = 0.0; }, kRequired, 3.5, 4.0},
        {"spring.index", "slack coil", pusher,
         [](Fixture& b) { b.spring.coil_diameter = 34 * kMm, b.spring.tensile_strength = 0.0, match_rate(b); }, kReview, 17.0, 16.0},
        {"spring.active_coils", "two", spool, [](Fixture& b) { wind(b, 2.0), b.spring.rod_diameter = 3 * kMm; }, kReview, 2.0, 3.0},
        {"spring.active_coils", "one and a half", spool, [](Fixture& b) { wind(b, 1.5), b.spring.rod_diameter = 3 * kMm; }, kRequired, 1.5,
         2.0},
        // 12 x 10/(10 + 10/(2 pi)) - 1.2 = 9.152370
        {"spring.rod", "close", spool, [](Fixture& b) { wind(b, 10), b.spring.rod_diameter = 9 * kMm; }, kReview, 1.0169300, 1.1},
        {"spring.rod", "seizes", spool, [](Fixture& b) { wind(b, 10), b.spring.rod_diameter = 9.5 * kMm; }, kRequired, 0.9634074, 1.0},
        {"spring.rod", "thick guide rod", pusher, [](Fixture& b) { b.spring.rod_diameter = 13 * kMm; }, kReview, 14.0 / 13.0, 1.1},
        {"spring.rate_scatter", "no room for a trim", spool, [](Fixture& b) { b.spring.max_state = 10.5; }, kReview, 100.0 / 9.0, 10.5},
    };
}

}  // namespace fusee::checks
