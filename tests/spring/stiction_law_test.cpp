#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "fusee/spring/laws.h"
#include "law_properties.h"
#include "refused.h"

namespace fusee::spring {
namespace {

StictionLawOptions design(double k, double u, double c, double start, double end) {
    return {.k = k, .u = u, .c = c, .mu = 0.28, .start_torque = start, .end_torque = end};
}

struct Golden {
    StictionLawOptions options;
    double theta, f_se, u_se;  // from start to end; 30-digit quadrature of eq. 5, 7 and 10
};
const Golden kGolden[] = {
    {design(0.69, 0.0027, 0.30, 0.5, 1.5), 0.77304375431332, 0.329618400886147, 0.316071216785352},
    {design(0.42, 0.03, 0.05, 0.12, 1.0), 5.54780801209373, 0.129584605381433, 0.591089678038514},
};

TEST(StictionLaw, AgreesWithThirtyDigitQuadrature) {
    for (const Golden& golden : kGolden) {
        const auto law = make_stiction_law(golden.options);
        ASSERT_TRUE(law);
        const LawPoint start = (*law)->at_load(golden.options.start_torque), end = (*law)->at_load(golden.options.end_torque);
        // The reference has 15 digits; 1e-13 leaves two for the sums of the closed form.
        EXPECT_NEAR(end.theta - start.theta, golden.theta, 1e-13 * golden.theta);
        EXPECT_NEAR(end.f_se - start.f_se, golden.f_se, 1e-13);
        EXPECT_NEAR(end.u_se, golden.u_se, 1e-13);
        EXPECT_NEAR(start.f_se, start.transmission() * golden.options.start_torque, 1e-15);
        EXPECT_EQ(start.theta, 0.0);
    }
}

TEST(StictionLaw, MeetsThePapersDefinitions) {
    const StictionLawOptions o = kGolden[1].options;
    const auto law = make_stiction_law(o);
    ASSERT_TRUE(law);
    for (const LawPoint& p : sample_by_load(**law, 50)) {
        EXPECT_NEAR(p.s, o.k * p.tau * p.tau, 1e-15);                                            // (16)
        EXPECT_NEAR(p.transmission(), o.u * o.u / (o.mu * p.tau * p.tau) + o.c / p.tau, 1e-15);  // (11)
        EXPECT_NEAR(p.p, (1.0 / p.transmission() - 1.0) * p.s, 1e-14);                           // (12)
    }
}

/// theta_inf, the angle at which the load would be infinite, counted from the law's start.
double asymptote(const StictionLawOptions& o) {
    return (o.u * o.u / (3.0 * o.mu * std::pow(o.start_torque, 3)) + o.c / (2.0 * std::pow(o.start_torque, 2))) / o.k;
}

/// The paper's (19) at the law's angle theta: has the cubic between angle and load one real root?
bool single_real_root(const StictionLawOptions& o, double theta) {
    const double x = theta - asymptote(o);  // below 0: P(19) is x^3 (...) > 0
    return std::pow(o.c, 3) * o.mu * o.mu + 6.0 * o.k * x * std::pow(o.u, 4) < 0.0;
}

/// Paper (18) with the angle counted from the asymptote, x = theta - theta_inf < 0: Cardano's radical for the real root of
/// 6 k mu x tau^3 + 3 mu C tau + 2 u^2 = 0, valid where that root is the only one (19).
double radical_form(const StictionLawOptions& o, double x) {
    const double inside =
        6.0 * std::pow(o.k, 3) * std::pow(o.mu, 4) * std::pow(x, 3) * (std::pow(o.c, 3) * o.mu * o.mu + 6.0 * o.k * x * std::pow(o.u, 4));
    EXPECT_GT(inside, 0.0);  // (19)
    const double gamma = std::sqrt(inside) + 6.0 * o.k * o.k * o.mu * o.mu * x * x * o.u * o.u;
    return (std::cbrt(6.0) * o.k * x * o.c * o.mu * o.mu - std::cbrt(gamma * gamma)) / (std::cbrt(36.0 * gamma) * o.k * x * o.mu);
}

TEST(StictionLaw, InverseAgreesWithTheRadicalForm) {
    for (const StictionLawOptions& o : {design(0.42, 0.5, -0.05, 1.0, 2.5), design(0.3, 0.2, 0.05, 0.8, 1.2)}) {
        const auto law = make_stiction_law(o);
        ASSERT_TRUE(law);
        for (int i = 0; i <= 20; ++i) {
            const double theta = (*law)->angles().high * i / 20.0;
            ASSERT_TRUE(single_real_root(o, theta));
            const double tau = radical_form(o, theta - asymptote(o));
            EXPECT_NEAR((*law)->at_angle(theta).tau, tau, 1e-13 * tau);
        }
    }
}

/// (19) tells how many roots the cubic has, not whether there is a law: both known designs break it and are pairs of springs.
TEST(StictionLaw, ThreeRealRootsMakeNoWorseALaw) {
    for (const Golden& golden : kGolden) {
        const auto law = make_stiction_law(golden.options);
        ASSERT_TRUE(law);
        EXPECT_FALSE(single_real_root(golden.options, 0.5 * golden.theta));
        EXPECT_TRUE(check_law(**law).empty());
    }
}

TEST(StictionLaw, IsLawfulOverItsWholeParameterSpace) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        StictionLawOptions o = design(std::pow(10.0, -2.0 + 3.0 * unit(random)), 0.2 * unit(random), 0.4 * unit(random) - 0.1, 1.0, 2.0);
        o.mu = 0.05 + 0.4 * unit(random);
        const double a = o.u * o.u / o.mu, least = (o.c + std::sqrt(o.c * o.c + 4.0 * a)) / 2.0;
        if (least < 1e-3) continue;
        o.start_torque = least * (1.02 + 2.0 * unit(random));
        o.end_torque = o.start_torque * (1.2 + 2.0 * unit(random));
        if (o.c < 0.0) o.end_torque = std::min(o.end_torque, 0.95 * a / -o.c);
        if (o.end_torque < 1.05 * o.start_torque) continue;
        SCOPED_TRACE(testing::Message() << "k " << o.k << " u " << o.u << " C " << o.c << " mu " << o.mu << " from " << o.start_torque
                                        << " to " << o.end_torque);
        const auto law = make_stiction_law(o);
        ASSERT_TRUE(law);
        expect_lawful(**law, 1e-6);  // P has a pole just above the end for C < 0
        EXPECT_TRUE(check_law(**law).empty());
    }
}

TEST(StictionLaw, ClampsToItsRange) {
    const auto law = make_stiction_law(kGolden[0].options);
    EXPECT_EQ((*law)->at_load(0.1).tau, 0.5);
    EXPECT_EQ((*law)->at_load(9.0).tau, 1.5);
    EXPECT_EQ((*law)->at_angle(-1.0).tau, 0.5);
    EXPECT_EQ((*law)->at_angle(9.0).theta, (*law)->angles().high);
}

TEST(StictionLawRefusal, StartTooLowNamesTheLeastTorqueAndTheChangeWorks) {
    StictionLawOptions o = design(0.42, 0.03, 0.30, 0.12, 1.0);
    const auto refused = make_stiction_law(o);
    ASSERT_FALSE(refused);
    const core::Finding& finding = refused.refusal().front();
    EXPECT_EQ(finding.rule, "law.transmission");
    EXPECT_EQ(finding.measured, 0.12);
    const double least = finding.allowed;
    EXPECT_NEAR(0.03 * 0.03 / (0.28 * least * least) + 0.30 / least, 1.0, 1e-14);
    double start = 0.0, c = 0.0;
    ASSERT_EQ(std::sscanf(finding.suggestion.text().c_str(), "law.start_torque_Nm = %lf, or law.c_Nm = %lf", &start, &c), 2)
        << finding.suggestion.text();
    EXPECT_LT(start, least * 1.03);
    o.c = c;
    EXPECT_TRUE(make_stiction_law(o));
    o.c = 0.30;
    o.start_torque = start;
    EXPECT_TRUE(make_stiction_law(o));
}

TEST(StictionLawRefusal, EndTooHighNamesTheHighestTorqueAndTheChangeWorks) {
    StictionLawOptions o = design(0.42, 0.2, -0.1, 0.5, 2.0);
    const auto refused = make_stiction_law(o);
    ASSERT_FALSE(refused);
    const core::Finding& finding = refused.refusal().front();
    EXPECT_EQ(finding.measured, 2.0);
    EXPECT_NEAR(finding.allowed, 0.2 * 0.2 / (0.28 * 0.1), 1e-14);
    double end = 0.0, c = 0.0;
    ASSERT_EQ(std::sscanf(finding.suggestion.text().c_str(), "law.end_torque_Nm = %lf, or law.c_Nm = %lf", &end, &c), 2)
        << finding.suggestion.text();
    o.end_torque = end;
    EXPECT_TRUE(make_stiction_law(o));
    o.end_torque = 2.0;
    o.c = c;
    EXPECT_TRUE(make_stiction_law(o));
}

TEST(StictionLawRefusal, NoDeadBandReductionAndNegativeConstantAsksForAnotherConstant) {
    StictionLawOptions o = design(0.42, 0.0, -0.1, 0.5, 2.0);  // T = C/tau < 0 everywhere
    const auto refused = make_stiction_law(o);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.refusal().front().allowed, 0.0);
    ASSERT_EQ(std::sscanf(refused.refusal().front().suggestion.text().c_str(), "law.c_Nm = %lf", &o.c), 1);
    EXPECT_TRUE(make_stiction_law(o));
}

TEST(StictionLawRefusal, BadOptionsAreNamed) {
    const auto field = [](const StictionLawOptions& o) { return field_refused([&] { return make_stiction_law(o); }); };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(field(design(0.0, 0.03, 0.05, 0.12, 1.0)), "law.k_per_Nm_rad");
    EXPECT_EQ(field(design(0.42, nan, 0.05, 0.12, 1.0)), "law.u_Nm");
    EXPECT_EQ(field(design(0.42, 0.03, nan, 0.12, 1.0)), "law.c_Nm");
    EXPECT_EQ(field(design(0.42, 0.0, 0.0, 0.12, 1.0)), "law.c_Nm");
    EXPECT_EQ(field(design(0.42, 0.03, 0.05, -0.12, 1.0)), "law.start_torque_Nm");
    EXPECT_EQ(field(design(0.42, 0.03, 0.05, 0.12, 0.12)), "law.end_torque_Nm");
    StictionLawOptions slippery = design(0.42, 0.03, 0.05, 0.12, 1.0);
    slippery.mu = 0.0;
    EXPECT_EQ(field(slippery), "rig.gear_friction");
}

}  // namespace
}  // namespace fusee::spring
