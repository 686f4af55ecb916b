#include "fusee/spring/law.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fusee/core/error.h"
#include "fusee/spring/base_spring.h"

namespace fusee::spring {
namespace {

/// Load = 1 + theta over [0, 2] rad, its parallel stiffness P = 1 - S below 0 above `turn` rad.
class BrokenLaw final : public SpringLaw {
public:
    explicit BrokenLaw(double turn) : turn_(turn) {}
    [[nodiscard]] core::Range loads() const override { return {1.0, 3.0}; }
    [[nodiscard]] core::Range angles() const override { return {0.0, 2.0}; }
    [[nodiscard]] LawPoint at_load(double tau) const override { return at_angle(tau - 1.0); }
    [[nodiscard]] LawPoint at_angle(double theta) const override {
        LawPoint p;
        p.theta = std::clamp(theta, 0.0, 2.0);
        p.tau = 1.0 + p.theta;
        p.s = 0.5 + 0.5 * p.theta / turn_;
        p.p = 1.0 - p.s;
        p.f_se = 0.5 + p.theta * (0.5 + 0.25 * p.theta / turn_);
        p.f_pe = p.tau - p.f_se;
        return p;
    }

private:
    double turn_;
};

TEST(SampleByLoad, IsEvenAndHoldsBothEnds) {
    const BrokenLaw law(5.0);
    const auto points = sample_by_load(law, 5);
    ASSERT_EQ(points.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(points[i].tau, 1.0 + 0.5 * static_cast<double>(i));
    EXPECT_THROW((void)sample_by_load(law, 1), core::InvalidInput);
}

TEST(CheckLaw, SaysNothingOfASoundLaw) { EXPECT_TRUE(check_law(BrokenLaw(5.0)).empty()); }

TEST(CheckLaw, NamesTheFirstAndTheWorstPlace) {
    const auto findings = check_law(BrokenLaw(1.0));
    ASSERT_TRUE(core::any_error(findings));
    const auto stiffness = std::find_if(findings.begin(), findings.end(), [](const core::Finding& f) { return f.rule == "law.stiffness"; });
    ASSERT_NE(stiffness, findings.end());
    EXPECT_NEAR(stiffness->measured, -0.5, 1e-15);  // P at 2 rad
    EXPECT_EQ(stiffness->where, "law at 2 Nm first, worst at 3 Nm");
    EXPECT_EQ(stiffness->suggestion.text(), "law.end_torque_Nm = 1.998");  // one step of 2 Nm / 800 before
    EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const core::Finding& f) { return f.rule == "law.transmission"; }));
}

TEST(CheckLaw, OfAnEndThatIsNoLawSuggestsOneSpringAlone) {
    const auto suggested = [](double turn) { return check_law(BrokenLaw(turn)).front().suggestion; };
    EXPECT_EQ(suggested(0.5).changes().size(), 1u) << "a quarter of the loads is left";
    EXPECT_TRUE(suggested(0.2).changes().empty());
    EXPECT_EQ(suggested(0.2).text(),
              "another law: less than a fifth of this one is feasible, or one spring alone, which may have any torque: kind = \"spring\"");
}

TEST(BaseSpring, StoresTheEnergyThatMovesIt) {
    BaseSpring spring;
    spring.rate = 0.02;
    spring.preload = 4.0;
    EXPECT_EQ(spring.state(0.0), 4.0);
    EXPECT_NEAR(spring.state(0.5 * 0.02 * (25.0 - 16.0)), 5.0, 1e-15);
    EXPECT_NEAR(spring.load(0.5 * 0.02 * (25.0 - 16.0)), 0.1, 1e-16);
}

}  // namespace
}  // namespace fusee::spring
