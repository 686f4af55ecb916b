#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "fusee/spring/laws.h"
#include "law_properties.h"
#include "math/callable.h"
#include "refused.h"

namespace fusee::spring {
namespace {

constexpr core::Range kEverywhere{0.0, 100.0};

math::CurvePtr constant(double value) {
    return fixtures::make_curve([=](double, int order) { return order == 0 ? value : 0.0; }, kEverywhere);
}
/// k tau^2 with its slope.
math::CurvePtr square(double k) {
    return fixtures::make_curve([=](double tau, int order) { return order == 0 ? k * tau * tau : 2.0 * k * tau; }, kEverywhere);
}
/// a/tau^2 + C/tau with its slope, paper (11).
math::CurvePtr stiction_transmission(double a, double c) {
    return fixtures::make_curve(
        [=](double tau, int order) { return order == 0 ? (a / tau + c) / tau : -(2.0 * a / tau + c) / (tau * tau); }, kEverywhere);
}

TEST(TransmissionLaw, ConstantTransmissionIsKnownByHand) {
    // T = 1/4, S = 2 tau^2: theta = (1/s - 1/tau)/8, F_SE = tau/4, U = integral of tau/8 tau^-2 = ln(tau/s)/8, a quarter of it in K_SE.
    const auto law = make_transmission_law(square(2.0), constant(0.25), 0.5, 2.0);
    ASSERT_TRUE(law);
    EXPECT_NEAR((*law)->angles().high, (2.0 - 0.5) / 8.0, 1e-15);
    for (const LawPoint& p : sample_by_load(**law, 11)) {
        EXPECT_NEAR(p.theta, (2.0 - 1.0 / p.tau) / 8.0, 1e-14);
        EXPECT_NEAR(p.f_se, p.tau / 4.0, 1e-14);
        EXPECT_NEAR(p.p, 6.0 * p.tau * p.tau, 1e-13);
        EXPECT_NEAR(p.u_se, std::log(p.tau / 0.5) / 32.0, 1e-14);
        EXPECT_NEAR(p.u_pe, 3.0 * std::log(p.tau / 0.5) / 32.0, 1e-14);
        EXPECT_NEAR(p.s_slope, 4.0 * p.tau * 8.0 * p.tau * p.tau, 1e-11);
    }
}

struct Design {
    double k, u, c, start, end;
};
const Design kDesigns[] = {
    {0.69, 0.0027, 0.30, 0.5, 1.5}, {0.42, 0.03, 0.05, 0.12, 1.0}, {0.225, 0.0012, 0.265, 0.6, 2.1}, {0.42, 0.2, -0.1, 0.5, 1.4}};

TEST(TransmissionLaw, AgreesWithTheClosedLaw) {
    for (const Design& d : kDesigns) {
        const auto closed = make_stiction_law({.k = d.k, .u = d.u, .c = d.c, .mu = 0.28, .start_torque = d.start, .end_torque = d.end});
        const auto law = make_transmission_law(square(d.k), stiction_transmission(d.u * d.u / 0.28, d.c), d.start, d.end);
        ASSERT_TRUE(closed && law);
        const LawPoint end = (*closed)->at_load(d.end);
        for (const LawPoint& p : sample_by_load(**closed, 101)) {
            const LawPoint q = (*law)->at_load(p.tau);
            // The promise: 1e-12 of the whole for what is integrated; P = (1/T - 1) S and its slope to rounding.
            EXPECT_NEAR(q.theta, p.theta, 1e-12 * end.theta);
            EXPECT_NEAR(q.f_se, p.f_se, 1e-12 * end.f_se);
            EXPECT_NEAR(q.f_pe, p.f_pe, 1e-12 * end.f_pe);
            EXPECT_NEAR(q.u_se, p.u_se, 1e-12 * end.u_se);
            EXPECT_NEAR(q.u_pe, p.u_pe, 1e-12 * end.u_pe);
            EXPECT_NEAR(q.s, p.s, 1e-14 * p.s);
            EXPECT_NEAR(q.p, p.p, 1e-12 * p.p);
            EXPECT_NEAR(q.s_slope, p.s_slope, 1e-12 * std::abs(p.s_slope));
            EXPECT_NEAR(q.p_slope, p.p_slope, 1e-11 * std::abs(p.p_slope));
            EXPECT_NEAR((*law)->at_angle(p.theta).tau, (*closed)->at_angle(p.theta).tau, 1e-12 * end.tau + 1e-12 * (p.s + p.p) * end.theta);
        }
        expect_lawful(**law, 1e-6);
        EXPECT_TRUE(check_law(**law).empty());
    }
}

/// Near its ends the law is as exact as inside: what the first thousandth of the range adds, relative to itself.
TEST(TransmissionLaw, IsExactNearItsStart) {
    const auto law = make_transmission_law(square(2.0), constant(0.25), 0.5, 2.0);
    for (const double step : {1e-3, 1e-6, 1e-9}) {
        const LawPoint p = (*law)->at_load(0.5 + step);
        EXPECT_NEAR(p.theta, step / (8.0 * 0.5 * (0.5 + step)), 1e-16);
        EXPECT_NEAR((*law)->at_angle(p.theta).tau, p.tau, 1e-15);
    }
    EXPECT_EQ((*law)->at_load(0.1).tau, 0.5);
    EXPECT_EQ((*law)->at_load(9.0).tau, 2.0);
    EXPECT_EQ((*law)->at_angle(9.0).theta, (*law)->angles().high);
}

TEST(TransmissionLaw, TakesFormulasAndTables) {
    const core::Range loads{0.4, 2.0};
    std::vector<double> tau, stiffness;
    for (int i = 0; i <= 40; ++i) {
        tau.push_back(0.4 + 0.04 * i);
        stiffness.push_back(0.3 * tau.back() * tau.back() + 0.05);
    }
    for (const math::CurvePtr& s : {math::make_formula("s", "0.3*tau^2 + 0.05", "tau", loads), math::make_interpolant(tau, stiffness)}) {
        const auto law = make_transmission_law(s, math::make_formula("t", "0.6*exp(-tau)", "tau", loads), 0.4, 2.0);
        ASSERT_TRUE(law);
        expect_lawful(**law, 1e-7);
        expect_smooth_lead_in(*law, 0.1);
        EXPECT_TRUE(check_law(**law).empty());
        EXPECT_NEAR((*law)->at_load(1.0).f_se, 0.6 * (0.4 * std::exp(-0.4) + std::exp(-0.4) - std::exp(-1.0)), 1e-12);
    }
}

TEST(TransmissionLawRefusal, TransmissionOutsideItsRangeNamesTheLoadAndTheChangeWorks) {
    // T = 0.9 tau reaches 1 at 1.11 Nm.
    const auto rising = fixtures::make_curve([](double tau, int order) { return order == 0 ? 0.9 * tau : 0.9; }, kEverywhere);
    const auto refused = make_transmission_law(square(1.0), rising, 0.5, 2.0);
    ASSERT_FALSE(refused);
    const core::Finding& finding = refused.refusal().front();
    EXPECT_EQ(finding.rule, "law.transmission");
    EXPECT_NEAR(finding.measured, 1.8, 1e-14);
    EXPECT_EQ(finding.allowed, 1.0);
    double end = 0.0;
    ASSERT_EQ(std::sscanf(finding.suggestion.text().c_str(), "law.end_torque_Nm = %lf", &end), 1) << finding.suggestion.text();
    EXPECT_NEAR(end, 1.0 / 0.9, 3e-3);
    EXPECT_TRUE(make_transmission_law(square(1.0), rising, 0.5, end));
    const auto falling = fixtures::make_curve([](double tau, int order) { return order == 0 ? 1.5 - tau : -1.0; }, kEverywhere);
    const auto twice = make_transmission_law(square(1.0), falling, 0.2, 1.8);
    ASSERT_FALSE(twice);
    ASSERT_EQ(twice.refusal().size(), 2u);  // above 1 and below 0
    for (const core::Finding& each : twice.refusal()) EXPECT_EQ(each.rule, "law.transmission");
}

TEST(TransmissionLawRefusal, VanishingStiffnessIsAFinding) {
    const auto falling = fixtures::make_curve([](double tau, int order) { return order == 0 ? 1.0 - tau : -1.0; }, kEverywhere);
    const auto refused = make_transmission_law(falling, constant(0.5), 0.2, 1.5);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.refusal().front().rule, "law.stiffness");
    EXPECT_NEAR(refused.refusal().front().measured, -0.5, 1e-15);
    EXPECT_FALSE(make_transmission_law(constant(0.0), constant(0.5), 0.2, 1.5));
    EXPECT_FALSE(make_transmission_law(constant(std::nan("")), constant(0.5), 0.2, 1.5));
}

/// A dip between the points of the look over the range is still met by the quadrature.
TEST(TransmissionLawRefusal, ANarrowDipIsFound) {
    const auto dip = [](double tau) { return 1.0 - 1.001 * std::exp(-std::pow((tau - 1.0007) / 3e-4, 2)); };
    const auto narrow = fixtures::make_curve([=](double tau, int order) { return order == 0 ? dip(tau) : 0.0; }, kEverywhere);
    const auto refused = make_transmission_law(narrow, constant(0.5), 0.2, 1.8);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.refusal().front().rule, "law.stiffness");
}

TEST(TransmissionLawRefusal, BadRangesAreNamed) {
    const auto field = [](double start, double end, const math::CurvePtr& s, const math::CurvePtr& t) {
        return field_refused([&] { return make_transmission_law(s, t, start, end); });
    };
    const math::CurvePtr half = constant(0.5), shorter = math::make_formula("t", "0.5", "tau", {0.3, 1.0});
    EXPECT_EQ(field(0.0, 1.0, half, half), "law.start_torque_Nm");
    EXPECT_EQ(field(1.0, 1.0, half, half), "law.end_torque_Nm");
    EXPECT_EQ(field(0.3, 1.1, half, shorter), "law.transmission");
    EXPECT_EQ(field(0.2, 1.0, shorter, half), "law.series_stiffness_Nm_per_rad");
    EXPECT_EQ(field(0.3, 1.0, shorter, shorter), "accepted");
}

}  // namespace
}  // namespace fusee::spring
