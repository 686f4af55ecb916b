#include "fusee/blind/score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/core/error.h"

// Known answers: made-up labels and diagnoses whose score can be counted by hand.
namespace fusee::blind {
namespace {

using diagnosis::VerdictKind;

diagnosis::FoundEffect found(const std::string& id, const std::string& side, double probability, double low = 0.0, double high = 1.0) {
    return {{id, side}, probability, {0.5 * (low + high), {low, high}, "1"}, {}};
}

/// Labels and answers that grow side by side.
struct Table {
    std::vector<Label> labels;
    std::vector<Answer> answers;

    Answer& add(std::vector<LabelEffect> truth, VerdictKind verdict, std::vector<diagnosis::FoundEffect> said = {}) {
        const std::string name = "case" + std::to_string(labels.size());
        const bool outside = !truth.empty() && truth.front().id.starts_with("outside.");
        labels.push_back({name, std::move(truth), !outside, "", {}});
        Answer answer;
        answer.case_name = name;
        answer.verdict = verdict;
        answer.effects = std::move(said);
        answer.claimed_before = answer.held_out_before = 8.0;
        answer.claimed_after = 1.0;
        answer.held_out_after = 2.0;
        answer.as_claimed = {10.0, 1.5};
        answer.seconds = static_cast<double>(labels.size());
        return answers.emplace_back(std::move(answer));
    }
    [[nodiscard]] Score score() const { return score_answers(labels, answers); }
};

const LabelEffect kCoulomb{"gear.coulomb", "agonist", 0.5, {}}, kRate{"se.rate", "both", 0.5, {}},
    kHarness{"outside.harness", "none", 1.0, {}};

diagnosis::UnknownTerm form(const std::string& port, const std::string& depends_on) {
    diagnosis::UnknownTerm term;
    term.port = port;
    term.depends_on = depends_on;
    return term;
}

/// Two of each kind of case, one of them answered well.
Table mixed() {
    Table t;
    t.add({kCoulomb}, VerdictKind::kIdentified, {found("gear.coulomb", "agonist", 0.97)});
    t.add({kCoulomb}, VerdictKind::kIdentified, {found("gear.coulomb", "both", 0.97)}).held_out_after = 7.0;
    t.add({kRate}, VerdictKind::kIdentified, {found("se.rate", "both", 0.6, 0.6, 0.9)});
    t.add({kRate}, VerdictKind::kAmbiguous, {found("se.radius", "both", 0.6)}).alternatives = {{{{"se.rate", "both"}}, 0.4}};
    t.add({}, VerdictKind::kNone);
    t.add({}, VerdictKind::kUnknown).form = {form("motor", "angle")};
    t.add({kCoulomb, kRate}, VerdictKind::kIdentified, {found("se.rate", "both", 1.0), found("gear.coulomb", "agonist", 1.0)});
    t.add({kCoulomb, kRate}, VerdictKind::kIdentified, {found("gear.coulomb", "agonist", 1.0)});
    t.add({kHarness}, VerdictKind::kUnknown).form = {form("joint", "time")};
    t.add({kHarness}, VerdictKind::kIdentified, {found("joint.gravity", "none", 0.3)});
    return t;
}

void expect_share(const Score& score, const std::string& key, std::size_t hits, std::size_t of) {
    EXPECT_EQ(score.figure(key).share.hits, hits) << key;
    EXPECT_EQ(score.figure(key).share.of, of) << key;
}

TEST(Share, HasWilsonsInterval) {
    // Newcombe 1998, table I, method 3: 81 of 263, 15 of 148, 0 of 20, 1 of 29.
    const auto expect_interval = [](std::size_t hits, std::size_t of, double low, double high) {
        const core::Range interval = Share{hits, of}.wilson95();
        EXPECT_NEAR(interval.low, low, 5e-5) << hits << " of " << of;
        EXPECT_NEAR(interval.high, high, 5e-5) << hits << " of " << of;
    };
    expect_interval(81, 263, 0.2553, 0.3662);
    expect_interval(15, 148, 0.0624, 0.1605);
    expect_interval(0, 20, 0.0, 0.1611);
    expect_interval(1, 29, 0.0061, 0.1718);
    expect_interval(20, 20, 1.0 - 0.1611, 1.0);
    EXPECT_TRUE(std::isnan(Share{}.value()));
}

TEST(ScoreAnswers, CountsEachFigureOverItsCases) {
    const Score score = mixed().score();
    EXPECT_EQ(score.cases, 10u);
    expect_share(score, "effect_named", 3, 4);
    expect_share(score, "effect_and_side", 2, 4);
    expect_share(score, "effect_left_open", 4, 4);
    expect_share(score, "none_on_null", 1, 2);
    expect_share(score, "both_of_two", 1, 2);
    expect_share(score, "both_of_two_and_sides", 1, 2);
    expect_share(score, "held_out_halved", 5, 6);
    expect_share(score, "unknown_called_unknown", 1, 2);
    expect_share(score, "known_called_unknown", 0, 6);
    expect_share(score, "known_not_seen", 0, 6);
    expect_share(score, "form_given", 1, 2);
    expect_share(score, "port_right", 1, 2);
    expect_share(score, "dependence_right", 0, 2);
    expect_share(score, "outside_identified", 1, 2);
    expect_share(score, "outside_misplaced", 0, 2);  // gravity enters at the joint, as a harness does
    expect_share(score, "outside_place", 2, 2);
    expect_share(score, "form_invented", 1, 8);
    expect_share(score, "intervals_hold", 4, 5);
    EXPECT_EQ(score.coverage.at("se.rate").hits, 1u);
    EXPECT_EQ(score.coverage.at("se.rate").of, 2u);
    EXPECT_EQ(score.median_seconds, 5.5);
    EXPECT_EQ(score.worst_seconds, 10.0);
}

TEST(ScoreAnswers, ConfusionHasEveryCaseOnce) {
    const auto confusion = mixed().score().confusion;
    const decltype(confusion) expected{{"gear.coulomb", {{"gear.coulomb", 2}}},
                                       {"se.rate", {{"se.rate", 1}, {"ambiguous", 1}}},
                                       {"none", {{"none", 1}, {"unknown", 1}}},
                                       {"two effects", {{"two effects", 1}, {"gear.coulomb", 1}}},
                                       {"outside.harness", {{"unknown", 1}, {"joint.gravity", 1}}}};
    EXPECT_EQ(confusion, expected);
}

TEST(ScoreAnswers, CalibrationCountsStatedEffects) {
    const Score score = mixed().score();
    std::vector<std::size_t> right, of;
    for (const CalibrationBin& bin : score.calibration) {
        right.push_back(bin.right.hits);
        of.push_back(bin.right.of);
    }
    EXPECT_EQ(right, (std::vector<std::size_t>{0, 0, 1, 0, 0, 0, 1, 0, 0, 3}));  // [0, 0.5) [0.5, 0.6) ... [0.999, 0.9999) [0.9999, 1]
    EXPECT_EQ(of, (std::vector<std::size_t>{1, 0, 2, 0, 0, 0, 2, 0, 0, 3}));
    EXPECT_DOUBLE_EQ(score.calibration[6].mean_stated, 0.97);
    EXPECT_TRUE(std::isnan(score.calibration[3].mean_stated));
}

TEST(ScoreAnswers, MissesSayWhatIsWrong) {
    std::map<std::string, std::string> misses;
    for (const Miss& miss : mixed().score().misses) misses[miss.truth.case_name] = miss.what;
    const decltype(misses) expected{{"case1", "another side, held-out gap not halved"},
                                    {"case2", "interval misses the true size"},
                                    {"case3", "left open"},
                                    {"case5", "faultless, called unknown"},
                                    {"case7", "one of two"},
                                    {"case9", "from outside, called joint.gravity"}};
    EXPECT_EQ(misses, expected);
}

TEST(ScoreAnswers, AnEffectThatIsPartOfTheExplanationIsNamed) {
    Table t;
    t.add({kCoulomb}, VerdictKind::kPartlyExplained, {found("gear.coulomb", "agonist", 1.0)});
    t.add({kCoulomb, kRate}, VerdictKind::kPartlyExplained, {found("se.rate", "both", 1.0)});
    t.add({kHarness}, VerdictKind::kPartlyExplained, {found("joint.gravity", "none", 1.0)});
    const Score score = t.score();
    expect_share(score, "effect_and_side", 1, 1);
    expect_share(score, "both_of_two", 0, 1);
    expect_share(score, "unknown_called_unknown", 0, 1);
    EXPECT_EQ(score.confusion.at("gear.coulomb").at("gear.coulomb"), 1u);
    ASSERT_EQ(score.misses.size(), 2u);
    EXPECT_EQ(score.misses[0].what, "one of two");
    EXPECT_EQ(score.misses[1].what, "from outside, called joint.gravity");
}

TEST(ScoreAnswers, ANameAtAnotherPlaceIsMisplaced) {
    Table t;
    t.add({{"outside.mount", "none", 0.2, {}}}, VerdictKind::kPartlyExplained,
          {found("cable.stretch", "both", 1.0), found("se.rate", "both", 1.0)});
    t.add({{"outside.zero_drift", "none", 0.1, {}}}, VerdictKind::kIdentified, {found("sensor.joint_offset", "none", 1.0)});
    t.add({{"outside.motor_fade", "both", -0.2, {}}}, VerdictKind::kUnknown).form = {form("motor", "angle")};
    t.add({{"outside.friction_rise", "both", 0.5, {}}}, VerdictKind::kUnknown);
    const Score score = t.score();
    expect_share(score, "outside_identified", 1, 4);
    expect_share(score, "outside_misplaced", 1, 4);
    expect_share(score, "outside_place", 2, 4);
    expect_share(score, "port_right", 1, 4);
}

TEST(ScoreAnswers, DoubtfulCasesAreRightWhenLeftOpenAndWrongWhenFalselyIdentified) {
    Table t;
    const auto doubt = [&](const std::string& why) { t.labels.back().doubt = why; };
    const LabelEffect other{"gear.coulomb", "antagonist", 0.2, {}};
    t.add({kCoulomb, other}, VerdictKind::kIdentified, {found("gear.coulomb", "agonist", 1.0), found("gear.coulomb", "antagonist", 1.0)});
    doubt("unequal sides");  // right
    t.add({kCoulomb, other}, VerdictKind::kIdentified, {found("gear.coulomb", "both", 1.0)});
    doubt("unequal sides");  // false
    t.add({kRate}, VerdictKind::kAmbiguous, {found("se.radius", "both", 0.6)}).alternatives = {{{{"se.rate", "both"}}, 0.4}};
    doubt("linear springs");  // right: left open
    t.add({kRate}, VerdictKind::kInconclusive);
    doubt("two experiments");  // right: it may not be seen
    t.labels.back().conditions.experiments = {"log", "breakaway"};
    t.add({kRate}, VerdictKind::kInconclusive);
    doubt("noise");  // neither right nor false
    t.add({}, VerdictKind::kNone);
    doubt("noise alone");  // right
    t.add({kRate, kCoulomb}, VerdictKind::kPartlyExplained, {found("se.rate", "both", 1.0)});
    doubt("three effects");                                                // neither
    t.add({}, VerdictKind::kIdentified, {found("se.rate", "both", 1.0)});  // an ordinary case
    const Score score = t.score();
    EXPECT_EQ(score.figure("doubtful_right").share.hits, 4U);
    EXPECT_EQ(score.figure("doubtful_right").share.of, 7U);
    EXPECT_EQ(score.figure("doubtful_false").share.hits, 1U);
    EXPECT_EQ(score.figure("doubtful_false").share.of, 7U);
}

TEST(ScoreAnswers, ShrinkIsComparedWithItsClaim) {
    const Score score = mixed().score();
    ASSERT_EQ(score.shrink.size(), 7u);  // one for each answer that names effects
    EXPECT_DOUBLE_EQ(score.shrink[0].claimed, 1.0 / 8.0);
    EXPECT_DOUBLE_EQ(score.shrink[0].measured, 2.0 / 8.0);
    EXPECT_DOUBLE_EQ(score.shrink[0].as_claimed, 1.5 / 10.0);
    EXPECT_DOUBLE_EQ(score.shrink[0].of_runs, 1.0 / 10.0);
    expect_share(score, "shrink_evenly", 0, 7);
    expect_share(score, "shrink_as_claimed", 7, 7);
    expect_share(score, "shrink_of_runs", 7, 7);
}

TEST(ScoreAnswers, ACaseWithoutADiagnosisIsAMiss) {
    Table t;
    t.add({kCoulomb}, VerdictKind::kUnknown).failure = "too few rows";
    t.answers[0].held_out_before = t.answers[0].held_out_after = diagnosis::kNoFigure;
    const Score score = t.score();
    expect_share(score, "effect_named", 0, 1);
    expect_share(score, "known_called_unknown", 0, 1);
    expect_share(score, "held_out_halved", 0, 1);
    EXPECT_EQ(score.confusion.at("gear.coulomb").at("failed"), 1u);
    ASSERT_EQ(score.misses.size(), 1u);
    EXPECT_EQ(score.misses[0].what, "no diagnosis: too few rows");
}

TEST(ScoreAnswers, ShuffledLabelsScoreAtChance) {
    Table t;  // 10 effects on 20 cases each, 50 faultless rigs, all answered right
    for (int i = 0; i < 200; ++i) {
        const std::string id = "effect." + std::to_string(i % 10);
        t.add({{id, "none", 0.5, {}}}, VerdictKind::kIdentified, {found(id, "none", 1.0)});
    }
    for (int i = 0; i < 50; ++i) t.add({}, VerdictKind::kNone);
    const Score score = t.score();
    const Figure& named = score.figure("effect_named");
    EXPECT_EQ(named.share.value(), 1.0);
    // A label meets each of the 250 answers at the same odds: 20 of them have its effect. One deal scatters by sqrt(0.08 0.92/200) = 0.019,
    // the mean of 400 by 0.001.
    EXPECT_NEAR(named.shuffled, 20.0 / 250.0, 0.004);
    EXPECT_NEAR(score.figure("none_on_null").shuffled, 50.0 / 250.0, 0.011);  // 0.2 0.8/50: 0.057 a deal
    EXPECT_LT(named.shuffled95.high, 0.15);
    EXPECT_GT(named.shuffled95.high, named.shuffled);
    EXPECT_LT(named.shuffled95.low, named.shuffled);
    EXPECT_TRUE(std::isnan(score.figure("held_out_halved").shuffled)) << "labels say nothing there";
    EXPECT_EQ(t.score().figure("effect_named").shuffled, named.shuffled) << "the same seed";
    EXPECT_NE(score_answers(t.labels, t.answers, 2).figure("effect_named").shuffled, named.shuffled);
}

TEST(ScoreAnswers, RefusesLabelsAndCasesThatDoNotMatch) {
    const Table t = mixed();
    Table fewer = t;
    fewer.labels.pop_back();
    EXPECT_THROW(static_cast<void>(fewer.score()), core::InvalidInput);
    fewer = t;
    fewer.answers.pop_back();
    EXPECT_THROW(static_cast<void>(fewer.score()), core::InvalidInput);
    fewer = t;
    fewer.answers[1].case_name = fewer.answers[0].case_name;
    EXPECT_THROW(static_cast<void>(fewer.score()), core::InvalidInput);
}

TEST(ScoreJson, HoldsFiguresMissesAndTheModel) {
    Score score = mixed().score();
    score.seal = "abc";
    const auto json = nlohmann::json::parse(score_json(score, score));
    EXPECT_EQ(json["seal"], "sha256:abc");
    EXPECT_EQ(json["figures"]["effect_named"]["hits"], 3);
    EXPECT_EQ(json["figures"]["effect_named"]["value"], 0.75);
    EXPECT_TRUE(json["figures"]["held_out_halved"]["shuffled"].is_null());
    EXPECT_EQ(json["confusion"]["se.rate"]["ambiguous"], 1);
    EXPECT_EQ(json["misses"].size(), 6u);
    EXPECT_EQ(json["misses"][2]["answer"]["alternatives"][0]["effects"][0]["id"], "se.rate");
    EXPECT_EQ(json["model"]["figures"], json["figures"]);
    EXPECT_TRUE(nlohmann::json::parse(score_json(score))["model"].is_null());
}

}  // namespace
}  // namespace fusee::blind
