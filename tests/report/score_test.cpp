#include "fusee/report/score.h"

#include "page_structure.h"
#include "score/words.h"

namespace fusee::report {
namespace {

using blind::Answer;
using blind::Label;

/// A case answered rightly, one answered `<wrongly>`, one without a diagnosis.
blind::Score three_cases() {
    const std::vector<Label> labels{
        {"case0", {{"pe.radius", "both", 2e-4, {}}}, true}, {"case1", {{"gear.coulomb", "agonist", 0.05, {}}}, true}, {"case2", {}, true}};
    std::vector<Answer> answers(3);
    for (std::size_t i = 0; i < 3; ++i) answers[i].case_name = labels[i].case_name;
    answers[0].verdict = answers[1].verdict = diagnosis::VerdictKind::kIdentified;
    answers[0].effects = {{{"pe.radius", "both"}, 0.97, {2.1e-4, {1.5e-4, 2.5e-4}, "m"}, {}}};
    answers[1].effects = {{{"<wrongly>", "both"}, 0.6, {1.0, {0.5, 1.5}, "1"}, {}}};
    answers[1].alternatives = {{{{"gear.coulomb", "agonist"}, {"se.rate", "both"}}, 0.3}, {{}, 0.1}};
    for (Answer& answer : answers) {
        answer.claimed_before = answer.held_out_before = 8.0;
        answer.claimed_after = answer.held_out_after = 1.0;
    }
    answers[2].failure = "too few rows";
    blind::Score score = score_answers(labels, answers);
    score.seal = "0123abcd";
    return score;
}

TEST(ScoreWords, StateTargetsTruthsAndAnswers) {
    EXPECT_EQ(per_cent(0.9512), "95.1 %");
    EXPECT_EQ(per_cent(diagnosis::kNoFigure), "\u2013");
    EXPECT_EQ(per_cent(core::Range{0.1, 0.25}), "10.0 to 25.0 %");
    EXPECT_EQ(wanted_text({0.95, 1.0}), "at least 95 %");
    EXPECT_EQ(wanted_text({0.9, 0.99}), "90 to 99 %");
    EXPECT_EQ(wanted_text({0.0, 0.05}), "at most 5 %");
    EXPECT_EQ(wanted_text({1.0, 1.0}), "100 %");
    EXPECT_EQ(wanted_text({0.0, 1.0}), "");
}

TEST(ScorePage, HoldsTheJsonAndTheSummary) {
    const blind::Score score = three_cases();
    expect_shell(score_html(score), "score", blind::score_json(score), score_text(score));
    expect_shell(score_html(score, score), "score", blind::score_json(score, score), score_text(score, score));
    const nlohmann::json json = data_of(score_html(score));
    ASSERT_EQ(json["misses"].size(), 2u);
    EXPECT_EQ(json["misses"][0]["truth"][0]["id"], "gear.coulomb");
    EXPECT_EQ(json["misses"][0]["answer"]["effects"][0]["id"], "<wrongly>");
    EXPECT_EQ(json["misses"][1]["answer"]["verdict"], "failed");
    for (const blind::Figure& figure : score.figures) EXPECT_EQ(json["figures"][figure.key]["name"], figure.name);
}

TEST(ScoreText, HasOneLineAFigure) {
    const blind::Score score = three_cases();
    const std::string text = score_text(score);
    for (const blind::Figure& figure : score.figures) expect_all(text, {figure.name.c_str()});
    expect_all(text, {"1/2", "50.0 %", "at least 95 %", "2 misses"});
    EXPECT_FALSE(holds(text, "model"));
    expect_all(score_text(score, score), {"model"});
}

}  // namespace
}  // namespace fusee::report
