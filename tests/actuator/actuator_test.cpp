#include <gtest/gtest.h>

#include "fusee/actuator/joint.h"
#include "fusee/spring/laws.h"
#include "refused.h"

namespace fusee::actuator {
namespace {

Actuator rig() {
    Actuator a;
    a.law = *spring::make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = 0.28, .start_torque = 0.6, .end_torque = 2.1});
    a.capstan_radius = 0.03;
    a.joint_radius = 0.045;
    a.gear_friction = spring::FrictionLaw::proportional(0.28);
    a.least_torque = 0.8;
    a.peak_torque = 1.0;
    a.overdrive_torque = 1.5;
    return a;
}

TEST(Actuator, StictionWidensTheLoads) {
    EXPECT_NEAR(rig().loads().low, 0.625, 1e-15);
    EXPECT_NEAR(rig().loads().high, 2.0833333333333335, 1e-15);
    EXPECT_NEAR(rig().ratio(), 1.5, 1e-15);
    EXPECT_NO_THROW(validate(rig()));
}

struct Fault {
    const char* field;
    void (*make)(Actuator&);
};

TEST(ActuatorRefusal, BadMembersAreNamed) {
    const Fault faults[] = {
        {"law", [](Actuator& a) { a.law = nullptr; }},
        {"capstan_radius", [](Actuator& a) { a.capstan_radius = 0.0; }},
        {"joint_radius", [](Actuator& a) { a.joint_radius = -0.01; }},
        {"least_torque", [](Actuator& a) { a.least_torque = 0.0; }},
        {"peak_torque", [](Actuator& a) { a.peak_torque = 0.5; }},
        {"overdrive_torque", [](Actuator& a) { a.overdrive_torque = 0.9; }},
    };
    for (const Fault& fault : faults) {
        Actuator broken = rig();
        fault.make(broken);
        EXPECT_EQ(field_refused([&] { validate(broken); }), fault.field);
    }
}

}  // namespace
}  // namespace fusee::actuator
