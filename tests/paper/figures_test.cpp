#include "figures.h"

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/headline.h"
#include "pipeline/fixture.h"

namespace fusee::paper {
namespace {

using namespace fixtures;

class Figures : public TempFolder {};

const NoiseCurve& find(const std::vector<NoiseCurve>& curves, const std::string& name) {
    for (const NoiseCurve& curve : curves)
        if (curve.name == name) return curve;
    throw std::out_of_range(name);
}

// Equal noise over equal dampers is one temperature T = N/(2 d) = 1 Nm rad, and a = b = 1: Var q = (1 + c)/(1 + 2 c) (docs/theory/noise.md,
// eq. 4), without the motor's spring 1/b. 1e-9: what the Lyapunov equation is solved to.
TEST(NoiseFigure, IsKnownByHandAtOneTemperature) {
    const auto curves = noise_figure();
    const NoiseCurve &both = find(curves, "both bodies"), &hanging = find(curves, "both bodies with a = 0");
    ASSERT_GT(both.c.size(), 40u);
    for (std::size_t i = 0; i < both.c.size(); ++i) {
        EXPECT_NEAR(both.joint[i], (1 + both.c[i]) / (1 + 2 * both.c[i]), 1e-9);
        EXPECT_NEAR(hanging.joint[i], 1.0, 1e-9);
    }
    EXPECT_TRUE(both.monotone());
    EXPECT_TRUE(hanging.monotone());
}

TEST(NoiseFigure, RefutesThePaperForANoisyMotorAndRefusesAFloatingJoint) {
    const auto curves = noise_figure();
    EXPECT_FALSE(find(curves, "the motor alone").monotone());
    EXPECT_TRUE(find(curves, "the joint alone").monotone());
    const NoiseCurve& floating = find(curves, "both bodies with a = b = 0");
    EXPECT_TRUE(floating.c.empty());
    EXPECT_NE(floating.refusal.find("noise.unbounded"), std::string::npos);
}

TEST(HillFigure, BothArrangementsAgreeAndThePassiveTensionStiffens) {
    const auto figure = hill_figure(profile::read_profile(shipped("first_prototype")));
    ASSERT_TRUE(figure);
    EXPECT_LT(figure->largest_difference(), 1e-12);  // forces of about 1 Nm, a dozen operations
    EXPECT_GT(figure->rows.back().series, figure->rows.front().series + 0.1);
    EXPECT_NEAR(1.0 / figure->parallel.k_pe, 1.0 / figure->series.k_se + 1.0 / figure->series.k_pe, 1e-9);
    for (std::size_t i = 2; i < figure->passive.size(); ++i) {
        const auto& p = figure->passive;
        EXPECT_GT(p[i].force - p[i - 1].force, p[i - 1].force - p[i - 2].force - 1e-12);
    }
}

TEST_F(Figures, ALawThatCannotBeIsRefusedByEachOfThem) {
    const auto changed =
        with_keys(core::read_file(shipped("pnrvsa")), {{"law.start_torque_Nm", "0.2"}, {"simulate.measured", "\"table.csv\""}});
    write("table.csv", "tau_Nm,width_deg\n0.9,60\n1.0,50\n");
    const profile::Profile profile = profile::read_profile(write("p.toml", changed));
    const auto hill = hill_figure(profile);
    const auto table = replay_table(profile);
    ASSERT_FALSE(hill);
    ASSERT_FALSE(table);
    EXPECT_EQ(hill.refusal().front().rule, "law.transmission");
    EXPECT_EQ(table.refusal().front().rule, "law.transmission");
}

TEST(ReplayTable, TableIRisesAndItsSpringsFailCondition6) {
    const auto table = replay_table(profile::read_profile(shipped("first_prototype")));
    ASSERT_TRUE(table);
    EXPECT_TRUE(table->rises());
    EXPECT_EQ(pipeline::condition_verdict(table->simulation.condition), pipeline::ConditionVerdict::kFails);
    ASSERT_EQ(table->parallel.size(), 4u);
    EXPECT_NEAR(table->parallel[0], 2 * 0.28 * 0.12 / core::rad_from_deg(3.5), 1e-12);
}

// The travel of docs/paper.md: the trapezes of DB/(2 mu tau) over the table's five rows.
TEST(ReplayTable, TableIIFallsAndImpliesTheTravelOfSoftSprings) {
    const auto table = replay_table(profile::read_profile(shipped("paper/new_springs")));
    ASSERT_TRUE(table);
    EXPECT_FALSE(table->rises());
    EXPECT_EQ(pipeline::condition_verdict(table->simulation.condition), pipeline::ConditionVerdict::kHolds);
    ASSERT_EQ(table->parallel.size(), 5u);
    EXPECT_NEAR(table->parallel.back(), 0.97, 0.005);
    EXPECT_NEAR(table->travel, 6.76, 0.01) << "by hand: DB as a broken line over tau, divided by 2 mu tau and integrated";
}

TEST_F(Figures, ATableNeedsMeasuredRows) {
    std::string bare = core::read_file(shipped("paper/new_springs"));
    bare.erase(bare.find("measured = "));
    try {
        (void)replay_table(profile::read_profile(write("bare.toml", bare)));
        FAIL() << "accepted";
    } catch (const core::InvalidInput& e) {
        EXPECT_NE(e.field().find("bare.toml"), std::string::npos) << e.field();
        EXPECT_NE(e.field().find("simulate.measured"), std::string::npos) << e.field();
    }
}

}  // namespace
}  // namespace fusee::paper
