#include "fusee/report/score.h"

#include <gtest/gtest.h>

#include "score/words.h"

namespace fusee::report {
namespace {

using blind::Answer;
using blind::Label;

/// A case answered rightly, one answered `<wrongly>`, one without a diagnosis.
blind::Score fixture() {
    const std::vector<Label> labels{
        {"case0", {{"pe.radius", "both", 2e-4, {}}}, true}, {"case1", {{"gear.coulomb", "agonist", 0.05, {}}}, true}, {"case2", {}, true}};
    std::vector<Answer> answers(3);
    for (std::size_t i = 0; i < 3; ++i) answers[i].case_name = labels[i].case_name;
    answers[0].verdict = answers[1].verdict = gap::Verdict::kIdentified;
    answers[0].effects = {{{"pe.radius", "both"}, 0.97, {2.1e-4, {1.5e-4, 2.5e-4}, "m"}, {}}};
    answers[1].effects = {{{"<wrongly>", "both"}, 0.6, {1.0, {0.5, 1.5}, "1"}, {}}};
    answers[1].alternatives = {{{{"gear.coulomb", "agonist"}, {"se.rate", "both"}}, 0.3}, {{}, 0.1}};
    for (Answer& answer : answers) {
        answer.claimed_before = answer.kept_before = 8.0;
        answer.claimed_after = answer.kept_after = 1.0;
    }
    answers[2].failure = "too few rows";
    blind::Score score = score_answers(labels, answers);
    score.seal = "0123abcd";
    return score;
}

void expect_words(const std::string& text, std::initializer_list<const char*> words) {
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' in\n" << text;
}

TEST(ScoreWords, SayWhatIsWantedAndSaid) {
    EXPECT_EQ(per_cent(0.9512), "95.1 %");
    EXPECT_EQ(per_cent(gap::kNoFigure), "\u2013");
    EXPECT_EQ(per_cent(core::Range{0.1, 0.25}), "10.0 to 25.0 %");
    EXPECT_EQ(wanted_text({0.95, 1.0}), "at least 95 %");
    EXPECT_EQ(wanted_text({0.9, 0.99}), "90 to 99 %");
    EXPECT_EQ(wanted_text({0.0, 0.05}), "at most 5 %");
    EXPECT_EQ(wanted_text({1.0, 1.0}), "100 %");
    EXPECT_EQ(wanted_text({0.0, 1.0}), "");
    const blind::Score score = fixture();
    ASSERT_EQ(score.misses.size(), 2u);
    EXPECT_EQ(truth_text(score.misses[0].truth), "gear.coulomb (agonist) 0.05");
    EXPECT_EQ(truth_text(score.misses[1].truth), "none");
    EXPECT_EQ(answer_text(score.misses[0].answer), "identified: <wrongly> (both) 1 (95 %: 0.5 to 1.5)");
    EXPECT_EQ(alternatives_text(score.misses[0].answer), "gear.coulomb (agonist) + se.rate (both) 0.3; none 0.1");
    EXPECT_EQ(answer_text(score.misses[1].answer), "failed");
}

TEST(ScorePage, HoldsFiguresAndEveryMissAndEscapesThem) {
    const blind::Score score = fixture();
    const std::string page = score_html(score);
    expect_words(page, {"3 sealed cases", "sha256:0123abcd", "1 of 2", "labels shuffled", "Confusion", "Calibration", "0.95 to 0.99",
                        "Shrink claimed and measured", "no diagnosis: too few rows", "&lt;wrongly&gt; (both)"});
    EXPECT_EQ(page.find("<wrongly>"), std::string::npos);
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_EQ(page.find("model = plant"), std::string::npos);
    expect_words(score_html(score, score), {"model = plant", "own cases (3)"});
}

TEST(ScoreText, HasOneLineAFigure) {
    const blind::Score score = fixture();
    const std::string text = score_text(score);
    for (const blind::Figure& figure : score.figures) expect_words(text, {figure.name.c_str()});
    expect_words(text, {"1/2", "50.0 %", "at least 95 %", "2 of the cases are missed"});
    EXPECT_EQ(text.find("model"), std::string::npos);
    expect_words(score_text(score, score), {"model"});
}

}  // namespace
}  // namespace fusee::report
