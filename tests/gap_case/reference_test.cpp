#include "fusee/gap_case/reference.h"

#include <gtest/gtest.h>

#include <map>

#include "gap_case/fixture.h"
#include "refused.h"

namespace fusee::gap_case {
namespace {

/// The small rig, whose springs end at 2 Nm, with other springs, radius and inertia.
NominalRig rig_of(double torque, double radius, double inertia) {
    NominalRig rig = fixtures::small_template().rig;
    for (NominalRig::SpringRow& row : rig.springs) {
        row.se_torque *= torque / 2.0;
        row.pe_torque *= torque / 2.0;
    }
    rig.capstan_radius = radius;
    rig.motor_inertia = inertia;
    return rig;
}

TEST(Reference, OfTheReferenceRigIsOneInEveryUnit) {
    const Reference one = reference_of(rig_of(2.6, 0.015, 0.002));
    for (const char* unit : {"Nm", "Nms", "Nm/rad", "1/Nm", "m", "N/m", "s", "rad/s", "kg m^2", "rad", "1", ""}) EXPECT_EQ(one.of(unit), 1.0) << unit;
}

TEST(Reference, OfAnotherRigIsAProductOfItsTorqueRadiusAndTime) {
    // 8 times the torque, twice the radius, 32 times the inertia: sqrt(32/8) = 2 times as slow
    const Reference r = reference_of(rig_of(20.8, 0.03, 0.064));
    const std::map<std::string, double> wanted{{"Nm", 8.0}, {"Nms", 16.0},    {"Nm/rad", 8.0}, {"1/Nm", 1.0 / 8.0}, {"m", 2.0},
                                               {"N/m", 2.0}, {"kg m^2", 32.0}, {"s", 2.0},      {"rad/s", 0.5},      {"rad", 1.0}};
    for (const auto& [unit, factor] : wanted) EXPECT_NEAR(r.of(unit), factor, 1e-11 * factor) << unit;
    EXPECT_EQ(r.decade(), 10.0);
}

TEST(Reference, OfARigThatStatesNothingIsThatOfTheReferenceRig) {
    const Reference none = reference_of({});
    EXPECT_EQ(none.torque * none.radius * none.time, 1.0);
}

TEST(Reference, RefusesAUnitThatItDoesNotKnow) { EXPECT_EQ(field_refused([] { return Reference{}.of("furlong"); }), "unit"); }

TEST(Usual, TolerancesAndSensorsFollowTheRig) {
    const NominalRig rig = rig_of(20.8, 0.03, 0.064);
    const Tolerance t = usual_tolerance(rig);
    EXPECT_NEAR(t.joint_coulomb, 0.04, 1e-12);
    EXPECT_NEAR(t.se_radius, 6e-5, 1e-15);
    EXPECT_NEAR(t.pe_preload, 1e-4, 1e-15);
    EXPECT_EQ(t.radii, Tolerance{}.radii);
    const Sensors s = usual_sensors(rig);
    EXPECT_NEAR(s.torque_noise, 0.012, 1e-12);
    EXPECT_EQ(s.encoder_step, Sensors{}.encoder_step);
    EXPECT_EQ(s.log_rate, Sensors{}.log_rate);
    EXPECT_EQ(usual_tolerance(rig_of(2.5, 0.015, 0.002), 3).joint_coulomb, 0.00481);  // 0.0048077
}

}  // namespace
}  // namespace fusee::gap_case
