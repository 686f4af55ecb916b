#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fusee/spring/laws.h"
#include "law_properties.h"
#include "refused.h"

namespace fusee::spring {
namespace {

FreeCurveOptions six_knots() {
    return {.loads = {0.4, 0.7, 1.0, 1.4, 1.8, 2.2},
            .series_stiffness = {0.08, 0.15, 0.3, 0.55, 0.9, 1.4},
            .transmission = {0.6, 0.45, 0.3, 0.2, 0.15, 0.12}};
}

TEST(FreeCurve, PassesThroughItsKnots) {
    const FreeCurveOptions o = six_knots();
    const auto law = make_free_curve(o);
    ASSERT_TRUE(law);
    EXPECT_EQ((*law)->loads().low, 0.4);
    EXPECT_EQ((*law)->loads().high, 2.2);
    for (std::size_t i = 0; i < o.loads.size(); ++i) {
        const LawPoint p = (*law)->at_load(o.loads[i]);
        EXPECT_NEAR(p.s, o.series_stiffness[i], 1e-14);
        EXPECT_NEAR(p.transmission(), o.transmission[i], 1e-14);
    }
    expect_lawful(**law, 1e-7);
    expect_smooth_lead_in(*law, 0.2);
}

/// ln S linear in ln tau is no polynomial in tau; a law of few knots with ln S and ln(S/P) linear in tau is known by hand.
TEST(FreeCurve, ExponentialsAreKnownByHand) {
    // S = e^tau, P = e^(2 tau): theta = integral of 1/(e^tau + e^2tau) = [-e^-tau - tau + ln(1 + e^tau)] ... by partial fractions
    FreeCurveOptions o;
    for (const double tau : {0.5, 0.8, 1.2, 1.6, 2.0}) {
        o.loads.push_back(tau);
        o.series_stiffness.push_back(std::exp(tau));
        o.transmission.push_back(1.0 / (1.0 + std::exp(tau)));
    }
    const auto law = make_free_curve(o);
    ASSERT_TRUE(law);
    const auto angle = [](double tau) { return -std::exp(-tau) - tau + std::log1p(std::exp(tau)); };
    const auto torque = [](double tau) { return tau - std::log1p(std::exp(tau)); };  // integral of T
    for (const LawPoint& p : sample_by_load(**law, 20)) {
        EXPECT_NEAR(p.theta, angle(p.tau) - angle(0.5), 1e-14);
        EXPECT_NEAR(p.f_se, 0.5 / (1.0 + std::exp(0.5)) + torque(p.tau) - torque(0.5), 1e-14);
    }
}

/// Every choice of knots is a pair of springs.
TEST(FreeCurve, AnyKnotsAreALaw) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 300; ++i) {
        FreeCurveOptions o;
        const int knots = 4 + i % 8;
        for (int j = 0; j < knots; ++j) {
            o.loads.push_back((o.loads.empty() ? 0.3 : o.loads.back()) + 0.1 + 0.1 * unit(random));
            o.series_stiffness.push_back(std::pow(10.0, -2.0 + 2.0 * unit(random)));
            o.transmission.push_back(0.02 + 0.96 * unit(random));
        }
        const auto law = make_free_curve(o);
        ASSERT_TRUE(law) << i;
        EXPECT_TRUE(check_law(**law).empty()) << i;
        const LawPoint end = (*law)->at_load(o.loads.back());
        for (const LawPoint& p : sample_by_load(**law, 15)) {
            // the angle knows the load to its own rounding times the stiffness there
            EXPECT_NEAR((*law)->at_angle(p.theta).tau, p.tau, 1e-14 * end.tau + 1e-14 * end.theta * (p.s + p.p)) << i;
        }
    }
}

TEST(FreeCurveRefusal, BadKnotsAreNamed) {
    const auto field = [](const FreeCurveOptions& options) { return field_refused([&] { return make_free_curve(options); }); };
    FreeCurveOptions o = six_knots();
    o.transmission[2] = 1.0;
    EXPECT_EQ(field(o), "law.transmission[2]");
    o = six_knots();
    o.series_stiffness[4] = 0.0;
    EXPECT_EQ(field(o), "law.series_Nm_per_rad[4]");
    o = six_knots();
    o.loads[1] = 0.4;
    EXPECT_EQ(field(o), "law.loads_Nm[1]");
    o = six_knots();
    o.transmission.pop_back();
    EXPECT_EQ(field(o), "law.transmission");
    EXPECT_EQ(field({.loads = {1, 2, 3}, .series_stiffness = {1, 1, 1}, .transmission = {0.5, 0.5, 0.5}}), "law.loads_Nm");
    o = six_knots();
    o.loads[0] = 0.0;
    EXPECT_EQ(field(o), "law.start_torque_Nm");
}

}  // namespace
}  // namespace fusee::spring
