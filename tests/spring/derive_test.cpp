#include <gtest/gtest.h>

#include "fusee/spring/coil.h"

namespace fusee::spring {
namespace {

BaseSpring rate_and_wire() {
    BaseSpring s;
    s.kind = BaseKind::kCompression;
    s.rate = 7460.0;
    s.preload = 14.6e-3;
    s.wire_diameter = 2.25e-3;
    s.coil_diameter = 18e-3;
    s.wire_class = WireClass::kSh;
    return s;
}

TEST(Derive, TurnsGiveTheRateAndTheRateIsThatOfTheTurns) {
    BaseSpring s = rate_and_wire();
    derive_coils(s);
    EXPECT_NEAR(s.active_coils, 6.0, 0.01);  // profiles/pnrvsa.toml states 6 turns for this rate
    EXPECT_NEAR(rate_of_coils(s), 7460.0, 1e-6);
    BaseSpring wound = rate_and_wire();
    wound.rate = 0.0;
    wound.active_coils = 5.0;
    derive_coils(wound);
    EXPECT_DOUBLE_EQ(wound.rate, rate_of_coils(wound));
}

TEST(Derive, WhatIsStatedStaysAndNothingFollowsWithoutCoils) {
    BaseSpring stated = rate_and_wire();
    stated.active_coils = 9.0;  // another rate: a finding, not a correction
    derive_coils(stated);
    EXPECT_EQ(stated.active_coils, 9.0);
    EXPECT_EQ(stated.rate, 7460.0);
    BaseSpring bare = rate_and_wire();
    bare.coil_diameter = 0.0;
    derive_coils(bare);
    derive_length_and_rating(bare, 21e-3);
    EXPECT_EQ(bare.active_coils, 0.0);
    EXPECT_EQ(bare.free_length, 0.0);
    EXPECT_EQ(bare.max_load, 0.0);
}

TEST(Derive, LengthAndRatingKeepTheLimitsOfTheRules) {
    BaseSpring s = rate_and_wire();
    derive_coils(s);
    const double state = 21.2e-3;
    derive_length_and_rating(s, state);
    EXPECT_LE(state, 0.8 * *travel_to_solid(s));         // spring.travel, without a review
    EXPECT_LE(state / 0.9, 0.85 * *travel_to_solid(s));  // spring.rate_scatter
    EXPECT_NEAR(s.free_length, 46e-3, 1.01e-3);          // the shipped one
    EXPECT_NEAR(s.max_load, s.rate * s.max_state, 1e-9);
    BaseSpring torsion;
    torsion.rate = 0.0183;
    torsion.wire_diameter = 1.1e-3;
    torsion.coil_diameter = 10e-3;
    torsion.wire_class = WireClass::kSh;
    derive_coils(torsion);
    derive_length_and_rating(torsion, 8.75);
    EXPECT_NEAR(torsion.active_coils, 25.75, 0.01);
    EXPECT_NEAR(torsion.free_length, 31.5e-3, 1e-9);  // axial space, torque and angle of the shipped one
    EXPECT_NEAR(torsion.max_load, 0.1821, 1e-4);
    EXPECT_NEAR(torsion.max_state, 9.948, 5e-3);
}

}  // namespace
}  // namespace fusee::spring
