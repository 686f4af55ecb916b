#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "fusee/spring/laws.h"
#include "law_properties.h"
#include "math/callable.h"
#include "refused.h"

namespace fusee::spring {
namespace {

constexpr core::Range kLoads{0.4, 2.0};
double wanted(double tau) { return 1.2 * std::exp(-1.5 * tau) + 0.1; }

math::CurvePtr formula(const std::string& text) { return math::make_formula("law.dead_band", text, "tau", kLoads); }
math::CurvePtr wanted_formula() { return formula("1.2*exp(-1.5*tau) + 0.1"); }

struct Rows {
    std::vector<double> tau, width;
};
Rows clean_rows(int count) {
    Rows rows;
    for (int i = 0; i < count; ++i) {
        rows.tau.push_back(kLoads.low + kLoads.width() * i / (count - 1));
        rows.width.push_back(wanted(rows.tau.back()));
    }
    rows.tau.back() = kLoads.high;
    return rows;
}

std::vector<spring::FrictionLaw> frictions() {
    return {spring::FrictionLaw::proportional(0.28), spring::FrictionLaw::affine(0.05, 0.2), spring::FrictionLaw::affine(0.02, 0.25, 0.3),
            spring::FrictionLaw::tabulated({0.0, 0.3, 0.7, 1.1, 2.5}, {0.01, 0.08, 0.21, 0.30, 0.72}, 0.1)};
}

/// The linear dead-band of a law's springs, full width at the joint.
double linear_dead_band(const LawPoint& p, const spring::FrictionLaw& friction, double ratio) {
    return 2.0 * friction.at_rest(p.tau) / (ratio * p.p);
}

/// The promise: the dead-band of the springs is the one asked for.
TEST(DeadBandLaw, GivesTheDeadBandAskedFor) {
    const Rows rows = clean_rows(61);
    const math::CurvePtr curves[] = {wanted_formula(), math::make_interpolant(rows.tau, rows.width)};
    const math::CurvePtr stiffnesses[] = {nullptr, formula("0.4 + 0.3*tau^2")};
    for (const spring::FrictionLaw& friction : frictions())
        for (const math::CurvePtr& curve : curves)
            for (const math::CurvePtr& s : stiffnesses) {
                const auto law = make_dead_band_law({.dead_band = curve,
                                                     .series_stiffness = s,
                                                     .start_transmission = 0.4,
                                                     .friction = friction,
                                                     .ratio = 1.5,
                                                     .start_torque = kLoads.low,
                                                     .end_torque = kLoads.high});
                ASSERT_TRUE(law) << core::to_line(law.refusal().front());
                for (const LawPoint& p : sample_by_load(**law, 200)) {
                    const double width = linear_dead_band(p, friction, 1.5);
                    EXPECT_NEAR(width, curve->value(p.tau), 1e-13 * width) << p.tau;
                    EXPECT_NEAR(linear_dead_band((*law)->at_angle(p.theta), friction, 1.5), width, 1e-11 * width) << p.tau;
                    // The clean rows: 60 intervals, sixth power. The smoothing spline has 16 intervals.
                    EXPECT_NEAR(width, wanted(p.tau), (curve == curves[2] ? 1e-5 : 1e-8) * width) << p.tau;
                    EXPECT_NEAR(p.s, s ? 0.4 + 0.3 * p.tau * p.tau : p.s, 1e-12);
                }
                const double start = (*law)->at_angle(0.0).transmission();
                EXPECT_NEAR(start, s ? start : 0.4, 1e-14);
                EXPECT_TRUE(check_law(**law).empty());
            }
}

TEST(DeadBandLaw, IsLawfulForEveryFriction) {
    for (const spring::FrictionLaw& friction : frictions()) {
        const auto law = make_dead_band_law(
            {.dead_band = wanted_formula(), .friction = friction, .start_torque = kLoads.low, .end_torque = kLoads.high});
        ASSERT_TRUE(law);
        // A table's friction is C1: the difference quotients of P and its slope cross kinks of the curvature, in steps of 1e-5.
        expect_lawful(**law, 1e-4);
        expect_smooth_lead_in(*law, 0.05);
    }
    const auto law = make_dead_band_law({.dead_band = wanted_formula(), .start_torque = kLoads.low, .end_torque = kLoads.high});
    expect_lawful(**law, 1e-7);
}

TEST(DeadBandLaw, HasItsClosedForm) {
    // DB = 2 mu tau/P with P = 3 S, S = k tau^2: DB = 2 mu/(3 k tau), so T = 1/4 everywhere.
    const double k = 0.5, mu = 0.28;
    const auto curve = fixtures::make_curve(
        [=](double tau, int order) { return 2.0 * mu / (3.0 * k) * (order == 0 ? 1.0 / tau : -1.0 / (tau * tau)); }, kLoads);
    const auto law = make_dead_band_law({.dead_band = curve, .start_transmission = 0.25, .start_torque = 0.5, .end_torque = 2.0});
    ASSERT_TRUE(law);
    for (const LawPoint& p : sample_by_load(**law, 20)) {
        EXPECT_NEAR(p.transmission(), 0.25, 1e-14);
        EXPECT_NEAR(p.s, k * p.tau * p.tau, 1e-14);
        EXPECT_NEAR(p.theta, (2.0 - 1.0 / p.tau) / (4.0 * k), 1e-13);
    }
}

/// A dead-band wide beyond measure leaves K_PE nothing to do, T -> 1; the narrowest one that is accepted has P = 1000 S, T -> 1/1001.
TEST(DeadBandLaw, TransmissionHasItsLimits) {
    const auto transmission = [](double width) {
        const auto law =
            make_dead_band_law({.dead_band = fixtures::make_curve([=](double, int order) { return order == 0 ? width : 0.0; }, kLoads),
                                .series_stiffness = formula("0.5"),
                                .friction = spring::FrictionLaw::affine(0.2, 0.0),
                                .start_torque = kLoads.low,
                                .end_torque = kLoads.high});
        return law ? (*law)->at_load(1.0).transmission() : std::nan("");
    };
    EXPECT_NEAR(transmission(1e6), 1.0, 1e-6);
    EXPECT_NEAR(transmission(0.8), 0.5, 1e-15);  // P = 2 * 0.2/0.8 = S
    EXPECT_NEAR(transmission(0.8001e-3), 1.0 / 1001.0, 1e-6);
    EXPECT_TRUE(std::isnan(transmission(0.7999e-3)));
}

TEST(DeadBandLawRefusal, VanishingDeadBandNamesTheLeastAndBothChangesWork) {
    DeadBandLawOptions options{.dead_band = formula("0.5 - 0.3*tau"), .start_torque = 0.4, .end_torque = 2.0};  // 0 at 1.667 Nm
    const auto refused = make_dead_band_law(options);
    ASSERT_FALSE(refused);
    const core::Finding& finding = refused.refusal().front();
    EXPECT_EQ(finding.rule, "law.dead_band");
    EXPECT_NEAR(core::rad_from_deg(finding.measured), -0.1, 1e-14);
    // P = 1000 S there, S = k tau^2 with T = 1/2 at the start: k = 2 mu s/(DB(s) s^2)
    const double k = 2.0 * 0.28 / (0.38 * 0.4);
    EXPECT_NEAR(core::rad_from_deg(finding.allowed), 2.0 * 0.28 * 2.0 / (1000.0 * k * 4.0), 1e-12);
    EXPECT_EQ(finding.where, "law at 2 Nm");
    double end = 0.0, width = 0.0;
    ASSERT_EQ(std::sscanf(finding.suggestion.text().c_str(), "law.end_torque_Nm = %lf, or law.dead_band_deg above %lf", &end, &width), 2)
        << finding.suggestion.text();
    options.end_torque = end;
    EXPECT_TRUE(make_dead_band_law(options));
    EXPECT_GT(end, 1.65);
    options.end_torque = 2.0;
    const double fall = std::log(0.38 / (1.01 * core::rad_from_deg(width))) / 1.6;  // an exponential down to the least width
    options.dead_band = fixtures::make_curve(
        [=](double tau, int order) { return 0.38 * std::exp(-fall * (tau - 0.4)) * (order == 0 ? 1.0 : -fall); }, kLoads);
    EXPECT_TRUE(make_dead_band_law(options));
}

TEST(DeadBandLawRefusal, ADeadBandThatBeginsBelowZeroAsksForALaterStart) {
    DeadBandLawOptions options{.dead_band = formula("0.3*tau - 0.2"), .start_torque = 0.4, .end_torque = 2.0};
    const auto refused = make_dead_band_law(options);
    ASSERT_FALSE(refused);
    ASSERT_EQ(std::sscanf(refused.refusal().front().suggestion.text().c_str(), "law.start_torque_Nm = %lf", &options.start_torque), 1)
        << refused.refusal().front().suggestion.text();
    EXPECT_TRUE(make_dead_band_law(options));
    options.start_torque = 0.4;
    options.dead_band = formula("-0.1");
    EXPECT_NE(make_dead_band_law(options).refusal().front().suggestion.text().find("no part"), std::string::npos);
}

TEST(DeadBandLawRefusal, NegativeSeriesStiffnessIsItsOwnFinding) {
    const auto refused =
        make_dead_band_law({.dead_band = formula("0.3"), .series_stiffness = formula("1 - tau"), .start_torque = 0.4, .end_torque = 2.0});
    ASSERT_FALSE(refused);
    bool stiffness = false;
    for (const core::Finding& finding : refused.refusal()) stiffness = stiffness || finding.rule == "law.stiffness";
    EXPECT_TRUE(stiffness);
}

TEST(DeadBandLawRefusal, BadOptionsAreNamed) {
    const auto field = [](const DeadBandLawOptions& options) { return field_refused([&] { return make_dead_band_law(options); }); };
    const DeadBandLawOptions good{.dead_band = wanted_formula(), .start_torque = 0.4, .end_torque = 2.0};
    EXPECT_EQ(field(good), "accepted");
    DeadBandLawOptions bad = good;
    bad.ratio = 0.0;
    EXPECT_EQ(field(bad), "rig.ratio");
    bad = good;
    bad.end_torque = 2.5;
    EXPECT_EQ(field(bad), "law.dead_band_deg");
    bad = good;
    bad.start_transmission = 1.0;
    EXPECT_EQ(field(bad), "law.start_transmission");
    bad = good;
    bad.friction = spring::FrictionLaw::proportional(0.0);
    EXPECT_EQ(field(bad), "rig.gear_friction");
    bad = good;
    bad.series_stiffness = math::make_formula("s", "1", "tau", {0.5, 2.0});
    EXPECT_EQ(field(bad), "law.series_stiffness_Nm_per_rad");
}

}  // namespace
}  // namespace fusee::spring
