#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "fusee/spring/laws.h"
#include "law_properties.h"
#include "refused.h"

namespace fusee::spring {
namespace {

GeneralStictionOptions general_design(const spring::FrictionLaw& friction) {
    return {.k = 0.42, .u = 0.1, .c = 0.10, .friction = friction, .start_torque = 0.35, .end_torque = 1.6};
}

TEST(GeneralStictionLaw, WithProportionalFrictionIsTheClosedLaw) {
    const GeneralStictionOptions o = general_design(spring::FrictionLaw::proportional(0.28));
    const auto closed =
        make_stiction_law({.k = o.k, .u = o.u, .c = o.c, .mu = 0.28, .start_torque = o.start_torque, .end_torque = o.end_torque});
    const auto law = make_general_stiction_law(o);
    ASSERT_TRUE(closed && law);
    const LawPoint end = (*closed)->at_load(o.end_torque);
    for (const LawPoint& p : sample_by_load(**closed, 101)) {
        const LawPoint q = (*law)->at_load(p.tau);
        for (const auto member : {&LawPoint::theta, &LawPoint::f_se, &LawPoint::f_pe, &LawPoint::s, &LawPoint::p, &LawPoint::s_slope,
                                  &LawPoint::p_slope, &LawPoint::u_se, &LawPoint::u_pe})
            EXPECT_NEAR(q.*member, p.*member, 1e-12 * std::abs(end.*member)) << p.tau;
    }
}

/// The transmitted stiction falls at the rate u^2/tau^2 for any friction.
TEST(GeneralStictionLaw, ReducesTransmittedStictionAtTheRateAskedFor) {
    const spring::FrictionLaw laws[] = {spring::FrictionLaw::affine(0.03, 0.22), spring::FrictionLaw::affine(0.03, 0.2, 0.25),
                                        spring::FrictionLaw::tabulated({0.0, 0.4, 0.8, 1.2, 2.0}, {0.02, 0.12, 0.26, 0.32, 0.6})};
    for (const spring::FrictionLaw& friction : laws) {
        const GeneralStictionOptions o = general_design(friction);
        const auto law = make_general_stiction_law(o);
        ASSERT_TRUE(law) << core::to_line(law.refusal().front());
        expect_lawful(**law, 1e-4);  // the table's friction has kinks of its curvature
        expect_smooth_lead_in(*law, 0.05);
        EXPECT_TRUE(check_law(**law).empty());
        const auto transmitted = [&](double tau) { return (*law)->at_load(tau).transmission() * friction.at_rest(tau); };
        const double h = 1e-5;
        for (double tau = 0.36; tau < 1.59; tau += 0.01) {
            EXPECT_NEAR((transmitted(tau + h) - transmitted(tau - h)) / (2.0 * h), -0.01 / (tau * tau), 1e-8);  // h^2 u^2/tau^4 = 7e-11
            EXPECT_NEAR((*law)->at_load(tau).s, 0.42 * tau * tau, 1e-14);
        }
    }
}

TEST(GeneralStictionLawRefusal, StartTooLowNamesALoadThatWorks) {
    GeneralStictionOptions o = general_design(spring::FrictionLaw::affine(0.03, 0.22));
    o.start_torque = 0.05;
    const auto refused = make_general_stiction_law(o);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.refusal().front().rule, "law.transmission");
    ASSERT_EQ(std::sscanf(refused.refusal().front().suggestion.text().c_str(), "law.start_torque_Nm = %lf", &o.start_torque), 1);
    EXPECT_TRUE(make_general_stiction_law(o));
}

TEST(GeneralStictionLawRefusal, BadOptionsAreNamed) {
    const auto field = [](const GeneralStictionOptions& options) {
        return field_refused([&] { return make_general_stiction_law(options); });
    };
    GeneralStictionOptions o = general_design(spring::FrictionLaw::proportional(0.28));
    o.k = 0.0;
    EXPECT_EQ(field(o), "law.k_per_Nm_rad");
    EXPECT_EQ(field(general_design(spring::FrictionLaw::proportional(0.0))), "rig.gear_friction");
}

}  // namespace
}  // namespace fusee::spring
