#include "fusee/search/one_spring.h"

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/search/init.h"
#include "one_spring/draft.h"
#include "pipeline/fixture.h"

// One spring: from its answers, or from another family's part, to a part that holds the energy of its law.
namespace fusee::search::one_spring {
namespace {

class OneSpringSearch : public fixtures::TempFolder {
protected:
    [[nodiscard]] profile::Profile asked(const std::string& formula, double from_deg, double to_deg, const std::string& bed = "200") const {
        init::Answers answers;
        answers.spring = true;
        for (const init::Question& question : init::questions(true)) {
            if (question.option == "--law") question.enter(answers, formula);
            if (question.option == "--from") question.enter(answers, std::to_string(from_deg));
            if (question.option == "--to") question.enter(answers, std::to_string(to_deg));
            if (question.option == "--bed") question.enter(answers, bed);
        }
        return init::first_spring(folder_ / "asked.toml", answers);
    }
};

TEST_F(OneSpringSearch, ReadsAFileWhoseColumnsAreNamed) {
    std::string rows = "Winkel;Moment\n";
    for (int i = 0; i <= 20; ++i) rows += std::to_string(3 * i) + ";" + std::to_string(300 + 5 * i) + "\n";
    init::Answers answers;
    answers.spring = true;
    answers.torque_law = write("law.csv", rows).string();
    EXPECT_THROW((void)init::first_spring(folder_ / "named.toml", answers), core::InvalidInput);
    answers.columns = core::CsvMapping::of({"angle_rad=Winkel in deg", "torque_Nm=Moment in mNm"});
    const profile::Profile named = init::first_spring(folder_ / "named.toml", answers);
    EXPECT_NEAR(task_of(named)->torque, 0.4, 1e-3);
    EXPECT_NEAR(task_of(named)->travel, core::rad_from_deg(60.0), 1e-9);
}

/// A link of 0.98 Nm from 30 deg before to 120 deg behind its upright position.
TEST_F(OneSpringSearch, KnowsTheEnergyOfItsLaw) {
    const Task task = task_of(asked("0.98*sin(x)", -30.0, 120.0)).value();
    EXPECT_NEAR(task.taken(), 0.98 * (1.0 - std::cos(core::kPi / 6.0)), 1e-6);
    EXPECT_NEAR(task.work(), 0.98 * 1.5, 1e-5);
    EXPECT_NEAR(task.torque, 0.98, 1e-4);
}

TEST_F(OneSpringSearch, DrawsEachFamilyWithTheEnergyAskedFor) {
    const profile::Profile p = asked("0.3+0.2*x", 0.0, 90.0);
    const Task task = task_of(p).value();
    for (const auto& [family, numbers] : {std::pair{"spool", 4U}, {"cable", 3U}, {"helix", 3U}, {"roller", 4U}, {"arm", 5U}}) {
        const Draft draft{.reserve = 2.0, .arm = 15e-3};
        const profile::Profile one = drawn(in_family(p, family), draft, task, false);
        EXPECT_EQ(one.name, std::string("asked-") + family);
        const spring::BaseSpring& s = one.part(one.part_kinds().front()).spring;
        EXPECT_EQ(s.kind == spring::BaseKind::kTorsion, std::string(family) == "spool");
        EXPECT_NEAR(0.5 * s.rate * s.preload * s.preload, 2.0 * task.work(), 5e-3 * task.work()) << family << ": four digits";
        EXPECT_EQ(variables_of(family, one, task, false).size(), numbers);
        EXPECT_EQ(one.k_pe.cam.roller.follower == cam::FollowerKind::kArm, std::string(family) == "arm");
        EXPECT_EQ(profile::parse_profile(profile::to_commented_toml(one), one.file).name, one.name);
    }
}

TEST_F(OneSpringSearch, TakesTheSpringOnSaleOfTheNearestRateWithTheSameEnergy) {
    const profile::Profile p = asked("0.3+0.2*x", 0.0, 90.0);
    const Task task = task_of(p).value();
    const Draft draft{.reserve = 2.0, .arm = 15e-3};
    const double wanted = drawn(in_family(p, "roller"), draft, task, false).k_pe.spring.rate;
    std::vector<spring::CatalogueSpring> sold(3);
    for (std::size_t i = 0; i < sold.size(); ++i) {
        sold[i].name = std::to_string(i);
        sold[i].spring.kind = spring::BaseKind::kCompression;
        sold[i].spring.rate = wanted * std::pow(1.5, static_cast<double>(i) - 1.2);
        sold[i].spring.wire_diameter = 2e-3;
    }
    EXPECT_EQ(nearest_sold(sold, wanted).name, "1");
    const spring::BaseSpring s = drawn(in_family(p, "roller"), draft, task, false, sold).k_pe.spring;
    EXPECT_NEAR(s.rate, sold[1].spring.rate, 1e-3 * s.rate) << "four digits";
    EXPECT_EQ(s.wire_diameter, 2e-3);
    EXPECT_EQ(s.cycles, p.k_pe.spring.cycles) << "as asked";
    EXPECT_NEAR(0.5 * s.rate * s.preload * s.preload, 2.0 * task.work(), 5e-3 * task.work());
}

TEST_F(OneSpringSearch, AsksForALawAndItsRange) {
    const auto field = [&](const std::string& law, double from, double to) {
        try {
            (void)asked(law, from, to);
        } catch (const core::InvalidInput& e) {
            return e.field();
        }
        return std::string("none");
    };
    EXPECT_EQ(field("none", 0.0, 10.0), "--law");
    EXPECT_EQ(field("0.5", 10.0, 10.0), "--to");
    EXPECT_EQ(field("law.csv", 0.0, 10.0), "--to");
}

/// With an anchor at a stated margin a search of one generation finds no part of two cables; the one that is asked about stands.
TEST_F(OneSpringSearch, KeepsThePartOfTheProfileWhereItFindsNone) {
    const std::string text = core::read_file(fixtures::shipped("single/two_cables"));
    const profile::Profile shipped = profile::read_profile(write("own.toml", text + "\n[cam.path]\nmargin_deg = 20.0\n"));
    const Family own = find_smallest(shipped, {.families = {"two_cables"}, .generations = 1, .files = false}).front();
    ASSERT_TRUE(own.found());
    EXPECT_FALSE(core::any_error(own.findings));
    EXPECT_GT(own.figures.height, 0.02) << "of both parts";
    const Family other = find_smallest(shipped, {.families = {"cable"}, .generations = 1, .files = false}).front();
    EXPECT_FALSE(other.found());
}

/// A step that no rim of this bed follows.
/// A margin that nobody states is placed for each contour: the written profile does not state the digits of its default.
TEST_F(OneSpringSearch, FindsTwoCablesThatAreSmallerThanTheShippedOnes) {
    const profile::Profile shipped = profile::read_profile(fixtures::shipped("single/two_cables"));
    EXPECT_EQ(profile::to_commented_toml(profile::rounded(shipped, 4)).find("margin_deg"), std::string::npos);
    const Figures own = figures_of(pipeline::evaluate(shipped, pipeline::Depth::kSolid), shipped, task_of(shipped)->torque);
    const Family found = find_smallest(shipped, {.families = {"two_cables"}, .generations = 12, .files = false}).front();
    ASSERT_TRUE(found.found()) << core::to_line(found.findings.front());
    // two unloaded springs of 15 active coils and 2 dead ones of 2.25 mm, 24.25 mm outside: longer than their solid length
    EXPECT_GT(own.spring_volume, 2.0 * 0.25 * core::kPi * 24.25e-3 * 24.25e-3 * 17.0 * 2.25e-3);
    EXPECT_LT(found.figures.room(), own.room());
    EXPECT_LT(found.figures.diameter, own.diameter);
    EXPECT_LT(found.figures.height, own.height);
}

TEST_F(OneSpringSearch, NamesWhatWouldHaveToChangeAndRepairsTheLaw) {
    const profile::Profile step = asked("0.6+0.35*tanh(25*x)", -35.0, 35.0, "50");
    const Family stuck = find_smallest(step, {.families = {"roller"}, .generations = 4, .files = false}).front();
    ASSERT_FALSE(stuck.found());
    ASSERT_FALSE(stuck.levers.empty());
    for (const Family::Lever& lever : stuck.levers) EXPECT_EQ(lever.value > lever.was, lever.what == "bed") << lever.what;

    const Family repaired = find_smallest(step, {.families = {"roller"}, .generations = 4, .repair = true, .files = false}).front();
    ASSERT_TRUE(repaired.found()) << core::to_line(repaired.findings.front());
    EXPECT_FALSE(core::any_error(repaired.findings));
    ASSERT_TRUE(repaired.changed);
    EXPECT_TRUE(repaired.levers.empty());
    const Family::ChangedLaw& law = *repaired.changed;
    EXPECT_GT(law.mean, 0.0);
    EXPECT_LT(law.mean, 0.1 * 0.95) << "a tenth of the largest torque";
    EXPECT_EQ(std::get<profile::OneSpring>(repaired.profile->law.curves).rows.y, law.now) << "the profile has the law that is shown";
    for (std::size_t i = 0; i < law.angle.size(); ++i) EXPECT_NEAR(law.wanted[i], 0.6 + 0.35 * std::tanh(25.0 * law.angle[i]), 1e-6);
}

TEST_F(OneSpringSearch, FindsAPartThatCanBeMadeAndSaysWhatBinds) {
    const std::vector<Family> families = find_smallest(
        asked("1.2*x", -20.0, 20.0), {.families = {"cable", "roller", "spool", "arm"}, .generations = 12, .front = true, .files = false});
    ASSERT_EQ(families.size(), 4U);
    for (const std::size_t pulls : {0U, 2U}) {
        EXPECT_FALSE(families[pulls].found()) << "a cable cannot push";
        ASSERT_FALSE(families[pulls].findings.empty());
        EXPECT_EQ(families[pulls].findings.front().rule, "cam.arm");
    }
    for (const std::size_t rolls : {1U, 3U}) {
        const Family& family = families[rolls];
        if (!family.found())
            GTEST_FAIL() << family.name << ": " << (family.findings.empty() ? "no finding" : core::to_line(family.findings.front()));
        EXPECT_FALSE(core::any_error(family.findings));
        EXPECT_GT(family.figures.diameter, 0.0);
        EXPECT_GT(family.figures.built_error, 0.082) << "the rate alone";
        EXPECT_GT(family.figures.guide_friction, 0.0);
        ASSERT_GT(family.front.size(), 1U);
        for (std::size_t i = 1; i < family.front.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_TRUE(family.front[i].built_error < family.front[k].built_error ||
                            family.front[i].guide_friction < family.front[k].guide_friction)
                    << "more room for nothing";
        EXPECT_EQ(profile::to_commented_toml(*family.profile).find("[cable]"), std::string::npos) << "a roller has none";
    }
    EXPECT_NE(profile::to_toml(*families[3].profile).find("follower = \"arm\""), std::string::npos);
}

}  // namespace
}  // namespace fusee::search::one_spring
