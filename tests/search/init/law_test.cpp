#include <gtest/gtest.h>

#include <cmath>

#include "fusee/search/init.h"
#include "init/levers.h"
#include "init/reach.h"
#include "init/repair.h"
#include "init/shapes.h"

namespace fusee::search::init {
namespace {

/// Springs over two radians that end at 3.33 and 3.22 Nm.
profile::TablePair rows() {
    profile::TablePair table;
    for (int i = 0; i <= 40; ++i) {
        const double x = 0.05 * i;
        table.angle.push_back(x);
        table.series.push_back(0.05 + 0.45 * x + 0.595 * x * x);
        table.parallel.push_back(0.25 * x + 0.08 * x * x + 0.3 * x * x * x);
    }
    return table;
}

Answers wanting(double torque) {
    Answers answers;
    answers.law = rows();
    answers.torque = torque;
    return answers;
}

const core::Change* change_of(const std::vector<OtherAnswers>& levers, const std::string& option) {
    for (const OtherAnswers& lever : levers)
        if (lever.changes.front().key == option) return &lever.changes.front();
    return nullptr;
}

TEST(MeasuredLaw, ReachesTheEdgesOfAModestTorqueAndNotThoseOfALargeOne) {
    const auto law = MeasuredLaw::of(rows());
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->angles().high, 2.0, 0.01);
    EXPECT_TRUE(law->missing(wanting(1.5)).empty());
    const core::Findings missing = law->missing(wanting(3.0));
    ASSERT_EQ(missing.size(), 1U);
    EXPECT_EQ(missing.front().rule, "cover.greatest");
    // A capstan rests at 4.5/(1 - 0.28) Nm, while the other one holds less: the law is asked for more than that.
    EXPECT_GT(missing.front().allowed, 4.5 / 0.72);
    EXPECT_NEAR(missing.front().measured, 6.55, 0.01);
}

TEST(MeasuredLaw, OfAConstantTorqueIsNoSpringOfAnAntagonist) {
    profile::TablePair constant = rows();
    for (double& torque : constant.parallel) torque = 1.0;
    const auto law = MeasuredLaw::of(constant);
    ASSERT_FALSE(law);
    EXPECT_EQ(law.refusal().front().rule, "law.stiffness");
    EXPECT_NE(law.refusal().front().what.find("parallel_Nm"), std::string::npos);
}

TEST(Levers, EachMeetsTheLimitAndItsNeighbourDoesNot) {
    const Answers answers = wanting(3.0);
    const core::Findings broken = broken_at_once(answers, {});
    ASSERT_FALSE(broken.empty());
    const std::vector<OtherAnswers> levers = find_levers(answers, broken, {});
    const auto law = MeasuredLaw::of(*answers.law);
    for (const auto& [option, back] : {std::pair{"--overdrive", 1.01}, {"--torque", 1.01}, {"--friction", 1.02}}) {
        const core::Change* lever = change_of(levers, option);
        ASSERT_TRUE(lever) << option;
        const double value = std::stod(lever->value);
        EXPECT_LT(value, std::stod(lever->was)) << option;
        EXPECT_TRUE(law->missing(changed(answers, option, lever->value)->answers).empty()) << option;
        EXPECT_FALSE(law->missing(changed(answers, option, std::to_string(back * value))->answers).empty()) << option;
    }
    EXPECT_EQ(change_of(levers, "--overdrive")->was, "4.5") << "0 stands for 1.5 times the torque";
}

TEST(Levers, ABedAndASizeAreNumbers) {
    Answers answers;
    answers.construction = "7x49";
    answers.cable = 2.5e-3;
    answers.shaft = 10e-3;
    answers.size = 60e-3;
    const core::Findings broken = broken_at_once(answers, {});
    ASSERT_FALSE(broken.empty());
    EXPECT_EQ(broken.front().rule, "limit.contour_radius");
    const Changed room = with_room(answers, 1e-3 * broken.back().measured);
    ASSERT_FALSE(room.other.changes.empty());
    EXPECT_EQ(room.other.changes.back().key, "--size");
    EXPECT_GE(room.answers.size, 2e-3 * broken.back().measured);
}

TEST(LeastContour, GrowsWithTheCable) {
    Answers thin, thick;
    thin.construction = thick.construction = "7x19";
    thin.cable = 1e-3;
    thick.cable = 2e-3;
    const double small = least_contour(cam::PartKind::kParallel, thin, 0).radius;
    const double large = least_contour(cam::PartKind::kParallel, thick, 0).radius;
    EXPECT_GT(small, 9.5e-3) << "the cable's least bend, 19/2 diameters";
    EXPECT_GT(large, 1.5 * small);
}

TEST(Repair, GoesOnAndLeavesTheMeasuredAnglesAsTheyAre) {
    const Answers answers = wanting(3.0);
    const auto repair = find_repair(answers, {});
    ASSERT_TRUE(repair);
    EXPECT_GT(repair->law.angle.back(), 2.05);
    EXPECT_NEAR(repair->measured.high, 2.0, 1e-9);
    for (std::size_t i = 0; i < repair->law.angle.size(); ++i) {
        const double x = repair->law.angle[i];
        if (!repair->measured.holds(x)) continue;
        EXPECT_NEAR(repair->law.series[i], 0.05 + 0.45 * x + 0.595 * x * x, 2e-3);
        EXPECT_NEAR(repair->law.parallel[i], 0.25 * x + 0.08 * x * x + 0.3 * x * x * x, 2e-3);
    }
    EXPECT_EQ(repair->series_change().mean, 0.0);
    EXPECT_EQ(repair_csv(*repair).substr(0, 31), "angle_rad,series_Nm,parallel_Nm");
}

}  // namespace
}  // namespace fusee::search::init
