#include "checks/known_bad.h"

namespace fusee::checks {

namespace {

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
         [](Fixture& b) { b.spring.coil_diameter = 32 * kMm, b.spring.free_length = 46 * kMm, b.spring.tensile_strength = 0.0; }, kReview,
         6.0, 7.744},
        {"spring.torsion_angle", "own limit", spool, [](Fixture& b) { b.spring.max_state = 8.0; }, kRequired, 10.0, 8.0},
        // 1.2 (10 + 1 + 10/(2 pi))
        {"spring.body_growth", "short space", spool, [](Fixture& b) { b.spring.active_coils = 10, b.spring.free_length = 14 * kMm; },
         kRequired, 15.109859, 14.0},
        {"spring.unwinding", "hardly preloaded", spool, [](Fixture& b) { preload(b, 0.05); }, kReview, 0.05, 0.1},
        {"spring.hand", "right hand", spool, [](Fixture& b) { b.spring.hand = spring::Hand::kRight; }, kRequired, -1.0, 0.0},
        {"spring.load", "torque", spool, [](Fixture& b) { b.spring.max_load = 0.15; }, kRequired, 0.2, 0.15},
        {"spring.load", "force", pusher, [](Fixture& b) { b.spring.max_load = 140; }, kRequired, 149.2, 140.0},
        // C = 10, K_B = 389/360, M = 0.2 Nm
        {"spring.stress", "bending", spool, [](Fixture& b) { b.spring.tensile_strength = 1000e6; }, kRequired, 1273.8945, 800.0, 1e-4},
        // C = 8, K_W = 31/28 + 0.615/8, F = 149.2 N; 1500 * 0.8/sqrt 3
        {"spring.stress", "shear", pusher, [](Fixture& b) { b.spring.tensile_strength = 1500e6; }, kRequired, 899.6988917, 692.820323,
         1e-4},
        {"spring.fatigue", "bending", spool, [](Fixture& b) { b.spring.cycles = 1e6; }, kRequired, 1273.8945, 1000.0, 1e-4},
        {"spring.fatigue", "shear", pusher, [](Fixture& b) { b.spring.cycles = 1e8; }, kRequired, 899.6988917, 600.0, 1e-4},
        {"spring.buckling", "slender", pusher, [](Fixture& b) { b.spring.free_length = 200 * kMm; }, kReview, 20.0, 14.9995030},
        {"spring.index", "tight coil", spool, [](Fixture& b) { without_slot(b), b.spring.coil_diameter = 4.2 * kMm; }, kReview, 3.5, 4.0},
        {"spring.index", "slack coil", pusher, [](Fixture& b) { b.spring.coil_diameter = 34 * kMm, b.spring.tensile_strength = 0.0; },
         kReview, 17.0, 16.0},
        {"spring.active_coils", "two", spool, [](Fixture& b) { b.spring.active_coils = 2.0; }, kReview, 2.0, 3.0},
        // 12 x 10/(10 + 10/(2 pi)) - 1.2 = 9.152370
        {"spring.rod", "close", spool, [](Fixture& b) { b.spring.active_coils = 10, b.spring.rod_diameter = 9 * kMm; }, kReview, 1.0169300,
         1.1},
        {"spring.rod", "seizes", spool, [](Fixture& b) { b.spring.active_coils = 10, b.spring.rod_diameter = 9.5 * kMm; }, kRequired,
         0.9634074, 1.0},
        {"spring.rod", "thick guide rod", pusher, [](Fixture& b) { b.spring.rod_diameter = 13 * kMm; }, kReview, 14.0 / 13.0, 1.1},
        {"spring.rate_scatter", "no room for a trim", spool, [](Fixture& b) { b.spring.max_state = 10.5; }, kReview, 100.0 / 9.0, 10.5},
    };
}

}  // namespace fusee::checks
