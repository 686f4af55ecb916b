#include <gtest/gtest.h>

#include <algorithm>

#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "fusee/profile/profile.h"
#include "fusee/search/init.h"
#include "init/search.h"
#include "long_form.h"

namespace fusee::search::init {
namespace {

/// fusee make accepts it, and no rule about springs, cable or material is open.
void expect_complete(const Result& result) {
    ASSERT_TRUE(result.design) << core::to_line(result.binding.front());
    const profile::Profile& p = result.design->profile;
    for (const spring::BaseSpring* s : {&p.k_se.spring, &p.k_pe.spring}) {
        EXPECT_GT(s->wire_diameter, 0.0);
        EXPECT_GT(s->active_coils, 0.0);
        EXPECT_GT(s->free_length, 0.0);
    }
    EXPECT_FALSE(core::any_error(result.design->findings));
    EXPECT_EQ(core::count(result.design->findings, core::Severity::kNotJudged), 0U);
}

TEST(FindDesign, TheDefaultAnswersGiveAJointThatTheFileReproduces) {
    double share = 0.0;
    const Result result = find_design("mine", {}, {.progress = [&](double now, const std::string&) { share = std::max(share, now); }});
    expect_complete(result);
    EXPECT_DOUBLE_EQ(share, 1.0);
    const std::string text = profile_text(*result.design, {});
    const profile::Profile again = profile::parse_profile(text, "mine.toml");
    EXPECT_EQ(profile::to_toml(again), profile::to_toml(result.design->profile));
    const std::string file = "tests/assembly/init.toml";  // the tests of the assembly put that joint together
    EXPECT_EQ(text, core::read_file(std::filesystem::path(FUSEE_SOURCE_DIR) / file)) << "fusee init mine.toml --yes writes " << file;
    // the comment is the schema's text
    EXPECT_NE(text.find("# r_c, radius at which the capstan takes the joint's cable\n"), std::string::npos);
    if (!fixtures::long_form()) return;
    Answers tiny;
    tiny.torque = 0.1;
    expect_complete(find_design("tiny", tiny, {}));
}

/// The measured springs stay as they are; cams and base springs are searched for them.
TEST(FindDesign, AMeasuredLawStaysThatOfTheFile) {
    Answers answers;
    const std::filesystem::path file = std::filesystem::path(FUSEE_SOURCE_DIR) / "profiles/measured_table.csv";
    answers.law = profile::read_measured_law(file);
    answers.torque = 0.8;
    answers.overdrive = 1.0;
    answers.least = 0.4;
    answers.friction = 0.2;
    const Searched found = search_scales("measured", answers, {.first = true}, {});
    EXPECT_TRUE(found.makeable) << core::to_line(found.binding.front());
    const auto& law = std::get<profile::TablePair>(found.profile.law.curves);
    EXPECT_EQ(law.file, file);
    EXPECT_EQ(law.series, answers.law->series);
    EXPECT_GE(found.profile.law.end_torque, 1.0 / (1.0 - 0.2)) << "stiction holds as much at 1 Nm";
    EXPECT_NE(profile_text({found.profile, {}}, answers).find("kind = \"table\""), std::string::npos);
}

TEST(FindDesign, AnImpossibleJointNamesLimitAndLevers) {
    Answers answers;  // 16 D/d of a 3 mm steel cable do not fit the bed
    answers.torque = 10.0;
    answers.construction = "7x49";
    answers.cable = 3e-3;
    answers.shaft = 20e-3;
    const Result result = find_design("large", answers, {});
    EXPECT_FALSE(result.design);
    ASSERT_FALSE(result.binding.empty());
    EXPECT_TRUE(result.binding.front().rule.starts_with("limit.")) << core::to_line(result.binding.front());
    EXPECT_TRUE(result.at_once) << "no candidate need be judged";
    EXPECT_EQ(result.judged, 0U);
    ASSERT_FALSE(result.levers.empty());
    for (const OtherAnswers& lever : result.levers) {
        EXPECT_NE(lever.changes.front().was, lever.changes.front().value);
        EXPECT_NE(lever.options.find(lever.changes.front().key), std::string::npos);
    }
}

/// The forces of 10 Nm are beyond a cable of 0.8 mm and the frame's screws: the answer is numbers that lead to a joint, and comes before
/// all candidates of two whole searches are judged.
TEST(FindDesign, LoadsThatNothingBearsNameWhatDoes) {
    Answers answers;
    answers.torque = 10.0;
    const Result result = find_design("heavy", answers, {});
    EXPECT_FALSE(result.design);
    EXPECT_LE(result.judged, 32U * 101U);
    ASSERT_FALSE(result.binding.empty());
    const core::Finding& worst = result.binding.front();
    EXPECT_TRUE(worst.rule.starts_with("cable.")) << core::to_line(worst);
    ASSERT_TRUE(result.nearest);
    EXPECT_EQ(result.nearest->changes.front().key, "--cable");
    Answers other = answers;
    for (const core::Change& change : result.nearest->changes)
        for (const Question& q : questions())
            if (q.option == change.key) q.enter(other, change.value);
    // a cable bears the square of its diameter
    EXPECT_GE(other.cable * other.cable / (answers.cable * answers.cable), worst.allowed / worst.measured);
    EXPECT_LT(other.torque, answers.torque) << "the screws of the frame";
    if (!fixtures::long_form()) return;  // the search itself has drawn one
    EXPECT_TRUE(find_design("lighter", other, {}).design);
}

/// What removes the first obstacle may not be enough: the search goes on in its direction, and names a number that leads to a joint.
TEST(FindDesign, AJointThatIsTooStiffNamesAStiffness) {
    Answers answers;
    answers.joint_stiffness = 20.0;
    const Result result = find_design("stiff", answers, {});
    EXPECT_FALSE(result.design);
    ASSERT_FALSE(result.levers.empty());
    const core::Change& lever = result.levers.front().changes.front();
    EXPECT_EQ(lever.key, "--joint-stiffness");
    ASSERT_TRUE(result.nearest);
    const core::Change& nearest = result.nearest->changes.front();
    EXPECT_EQ(nearest.key, "--joint-stiffness");
    EXPECT_LE(std::stod(nearest.value), std::stod(lever.value));
    EXPECT_GT(std::stod(nearest.value), 0.5) << "1.0 Nm/rad is what the start design has";
    if (!fixtures::long_form()) return;  // the search itself has drawn one
    answers.joint_stiffness = std::stod(nearest.value);
    EXPECT_TRUE(find_design("softer", answers, {}).design);
}

/// Springs for a thinner cable can be wound only for the best joint of a search, not for its first one without errors.
TEST(FindDesign, SpringsThatCannotBeWoundNameACable) {
    if (!fixtures::long_form()) GTEST_SKIP() << "half a minute: in the long form";
    Answers answers;
    answers.law = profile::read_measured_law(std::filesystem::path(FUSEE_SOURCE_DIR) / "profiles/measured_table.csv");
    answers.torque = 0.8;
    answers.least = 0.4;
    answers.friction = 0.2;
    answers.construction = "7x49";
    answers.cable = 3e-3;
    answers.bed = 0.4;
    const Result result = find_design("springs", answers, {});
    EXPECT_FALSE(result.design);
    EXPECT_EQ(result.binding.front().rule, "init.spring");
    ASSERT_TRUE(result.nearest);
    EXPECT_EQ(result.nearest->changes.front().value, "7x49 2.5");
}

TEST(FindDesign, AnyNumberOfThreadsGivesTheSameProfile) {
    const Searched one = search_scales("mine", {}, {.generations = 6}, {.jobs = 1}),
                   three = search_scales("mine", {}, {.generations = 6}, {.jobs = 3});
    EXPECT_EQ(profile::to_toml(one.profile), profile::to_toml(three.profile));
    EXPECT_EQ(one.judged, three.judged);
}

TEST(FindDesign, StopsWhenAsked) {
    EXPECT_THROW((void)find_design("mine", {}, {.stop = [] { return true; }}), core::Stopped);
}

}  // namespace
}  // namespace fusee::search::init
