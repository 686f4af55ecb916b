#include <gtest/gtest.h>

#include <limits>

#include "checks/fixture.h"

// Law: on a helix of constant radius the clearance of the free cable follows from one section of the neighbouring turn.
namespace fusee::checks {
namespace {

/// The neighbouring land's nearest point at direction delta from the contact: lip radius R + lip, height P (1/2 - delta/2 pi) below the
/// cable.
double room_by_hand(double radius, double lip, double pitch, double half_cable) {
    double least = std::numeric_limits<double>::infinity();
    for (double delta = 0.0; delta < core::kPi / 2.0; delta += 1e-4) {
        const double above = (radius + lip) * std::cos(delta) - radius, below = pitch * (0.5 - delta / (2.0 * core::kPi));
        least = std::min(least, (above >= 0.0 ? below : std::hypot(above, below)) - half_cable);
    }
    return least;
}

TEST(NeighbourTurns, ClearanceIsThatOfTheLandBetweenTurns) {
    for (const double pitch : {2.9, 3.4}) {
        Fixture b = helix(10.0 * kMm, pitch * kMm);
        b.part.options.groove.throat = core::rad_from_deg(60.0);
        b.part.options.groove.rib = 0.0;
        cut_groove(b);
        const double width = b.part.section.back().z_mm - b.part.section.front().z_mm;
        ASSERT_LT(width, pitch);
        b.part.options.groove.rib = (pitch - width) * kMm;  // land exactly as thick as the rib
        const core::Finding f = worst("groove.neighbour_turns", b);
        // 1 deg steps of psi: the height changes by P/360 from step to step
        EXPECT_NEAR(f.measured, room_by_hand(10.0, 0.8, pitch, 0.4), 1.5 * pitch / 360.0) << pitch;
        EXPECT_EQ(f.severity, core::Severity::kPass);
    }
}

TEST(NeighbourTurns, MirroredHelixHasTheSameClearance) {
    Fixture up = helix(10.0 * kMm, 3.8 * kMm), down = up;
    down.part.cam.path = [path = up.part.cam.path](double psi) {
        cam::PathPoint p = path(psi);
        p.z = -p.z;
        return p;
    };
    for (cam::Contact& c : down.part.cam.working) c.path.z = -c.path.z;
    EXPECT_NEAR(worst("groove.neighbour_turns", up).measured, worst("groove.neighbour_turns", down).measured, 1e-9);
}

TEST(NeighbourTurns, CableThatRisesIntoALargerTurnIsFound) {
    Fixture b = helix(10.0 * kMm, 4.0 * kMm);
    // The second turn is 8 mm farther out than the first; the cable rises towards it.
    b.part.cam.path = [](double psi) {
        const double h = psi > 2.0 * core::kPi ? 18.0 * kMm : 10.0 * kMm;
        return cam::PathPoint{psi, h, 0.0, h, 4.0 * kMm * psi / (2.0 * core::kPi)};
    };
    work(b, 0.0, 3.0 * core::kPi, 20.0 * kMm);
    b.part.cam.options.torque_sign = -1;  // leaves towards lower psi, where the groove does not rise with it
    const double level = worst("groove.neighbour_turns", b).measured;
    EXPECT_GE(level, 0.0);
    for (cam::Contact& c : b.part.cam.working) c.fleet = core::rad_from_deg(6.0);
    const core::Finding f = worst("groove.neighbour_turns", b);
    EXPECT_EQ(f.severity, core::Severity::kError) << core::to_line(f);
    EXPECT_LT(f.measured, level);
}

}  // namespace
}  // namespace fusee::checks
