#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fusee/core/error.h"
#include "fusee/spring/law.h"
#include "fusee/spring/laws.h"
#include "law_properties.h"

namespace fusee::spring {
namespace {

SpringLawPtr base_law() {
    return *make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = 0.28, .start_torque = 0.6, .end_torque = 2.1});
}

TEST(LeadIn, NoTravelIsTheLawItself) {
    const SpringLawPtr law = base_law();
    EXPECT_EQ(*with_lead_in(law, 0.0), law);
}

TEST(LeadIn, HasTheClosedFormAtItsLowerEnd) {
    const double travel = 1.2;
    const SpringLawPtr law = base_law();
    const LawPoint start = law->at_angle(0.0), low = (*with_lead_in(law, travel))->at_angle(0.0);
    EXPECT_NEAR(low.s, start.s - start.s_slope * travel / 2.0, 1e-15);
    EXPECT_NEAR(low.f_se, start.f_se - start.s * travel + start.s_slope * travel * travel / 3.0, 1e-15);
    EXPECT_EQ(low.s_slope, 0.0);
    EXPECT_EQ(low.p_slope, 0.0);
}

TEST(LeadIn, ExtentsAndLawfulness) {
    const SpringLawPtr law = base_law();
    const auto longer = with_lead_in(law, 1.2);
    ASSERT_TRUE(longer);
    EXPECT_EQ((*longer)->angles().high, law->angles().high + 1.2);
    EXPECT_EQ((*longer)->loads().high, law->loads().high);
    EXPECT_LT((*longer)->loads().low, law->loads().low);
    expect_lawful(**longer, 1e-7);
    EXPECT_TRUE(check_law(**longer).empty());
}

/// U''' is continuous: a step of 2 d across the junction changes nothing by more than O(d).
TEST(LeadIn, JunctionIsSmoothToTheThirdDerivativeOfTheEnergy) {
    const double travel = 0.8, d = 1e-9;
    const auto law = with_lead_in(base_law(), travel);
    const LawPoint below = (*law)->at_angle(travel - d), above = (*law)->at_angle(travel + d);
    for (const auto member : {&LawPoint::tau, &LawPoint::f_se, &LawPoint::f_pe, &LawPoint::s, &LawPoint::p, &LawPoint::s_slope,
                              &LawPoint::p_slope, &LawPoint::u_se, &LawPoint::u_pe})
        EXPECT_NEAR(below.*member, above.*member, 1e-8);  // 2 d times derivatives of order 1
}

TEST(LeadInRefusal, TooLongNamesTheLongestTravelAndItsBindingSpring) {
    const SpringLawPtr law = base_law();
    const auto refused = with_lead_in(law, 2.0);
    ASSERT_FALSE(refused);
    const core::Finding& finding = refused.refusal().front();
    EXPECT_EQ(finding.rule, "law.lead_in");
    EXPECT_EQ(finding.measured, core::deg_from_rad(2.0));
    const LawPoint start = law->at_angle(0.0);
    EXPECT_NEAR(core::rad_from_deg(finding.allowed), 2.0 * start.p / start.p_slope, 1e-14);  // here K_PE's stiffness fades first
    EXPECT_TRUE(with_lead_in(law, 0.999 * core::rad_from_deg(finding.allowed)));
    EXPECT_TRUE(check_law(**with_lead_in(law, 0.999 * core::rad_from_deg(finding.allowed))).empty());
    EXPECT_FALSE(with_lead_in(law, 1.001 * core::rad_from_deg(finding.allowed)));
}

TEST(LeadInRefusal, TorqueBindsForASteepStart) {
    // Nearly constant stiffness with little torque left: k small C large makes S' small against S.
    const SpringLawPtr law = *make_stiction_law({.k = 40.0, .u = 0.0, .c = 0.01, .mu = 0.28, .start_torque = 0.02, .end_torque = 0.4});
    const LawPoint start = law->at_angle(0.0);
    const auto refused = with_lead_in(law, 10.0);
    ASSERT_FALSE(refused);
    const double longest = core::rad_from_deg(refused.refusal().front().allowed);
    const auto nearly = with_lead_in(law, longest * (1.0 - 1e-9));
    ASSERT_TRUE(nearly);
    const LawPoint low = (*nearly)->at_angle(0.0);
    EXPECT_LT(std::min({low.f_se / start.f_se, low.f_pe / start.f_pe, low.s / start.s, low.p / start.p}), 1e-8);
}

TEST(LeadInRefusal, BadTravelIsNamed) {
    EXPECT_THROW((void)with_lead_in(base_law(), -0.1), core::InvalidInput);
    EXPECT_THROW((void)with_lead_in(base_law(), std::numeric_limits<double>::infinity()), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::spring
