#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/core/error.h"
#include "fusee/diagnosis/diagnosis.h"

// diagnosis.json: the keys that others read, and what a later prediction reads back.
namespace fusee::diagnosis {
namespace {

Diagnosis example() {
    Diagnosis d;
    d.case_name = "bench \xFF day";  // no UTF-8
    d.case_sha256 = "00ff";
    d.verdict = VerdictKind::kIdentified;
    d.effects = {{{"gear.coulomb", "agonist"}, 0.98, {0.1 + 0.2, {0.25, 0.35}, "Nm"}, {}},
                 {{"gear.stribeck", "both"}, 0.9, {0.4, {kNoFigure, kNoFigure}, ""}, {{"velocity", 0.05}}}};
    d.alternatives = {{{}, 0.01}, {{{"joint.coulomb", "none"}}, 0.005}};
    d.where = {{"dead_band", 0.62, "cocontraction_Nm", {0.12, 0.5}, "agonist"}};
    d.gap = {.before = 9.1, .after = 1.04, .noise_floor = 1.0};
    d.next_experiment = "break-away at 0.2 Nm";
    d.build = {{"radius_ratio", {1.002, {0.99, 1.01}, ""}}};
    d.experiments = {{"dead_band", 21, {.before = 8.0}, 1.1}};
    d.map = {{"dead_band", "cocontraction_Nm", {0.1, 0.2}, 3.0, 1.0, 6}};
    d.ranking = {{{{"gear.coulomb", "agonist"}}, 0.0, 0.98, 1800.0, kNoFigure, {{0.05, {0.04, 0.06}, "Nm"}}}};
    d.isolability = {{{"a", "none"}, {"b", "both"}}, {{1.0, 0.5}, {0.5, 1.0}}, {0.1, 0.2}, {0.2, 0.4}, {"Nm", ""}, {{0, 1}}};
    d.transfer = {{{{"law.series", "none"}}, "a.csv", "b.csv", 10.4, 3.0, 6.9, 7.9, {{9e-4, {}, "rad/Nm"}}, "Nm"}};
    d.power = {{{"loop.delay", "none"}, kNoFigure, 0.02, "s", false}};
    d.traces = {{"log", "q", "t_s", "q_rad", {0.0}, {0.0}, {0.0}, {0.0}, {1.0}}};
    d.next = {{"pull", "spring_pull", {0.5, 1.0}, "deflection_rad", 1.5, 20.0}};
    d.remarks = {"ten rows"};
    return d;
}

UnknownTerm ripple() {
    UnknownTerm term;
    term.found = {{"term.motor.ripple", "antagonist"}, 0.97, {0.04, {0.03, 0.05}, "Nm"}, {{"per_rad", 8.0}, {"phase", 0.5}}};
    term.port = "motor";
    term.depends_on = "angle";
    term.sentence = "It ripples.";
    term.log_odds = 80.0;
    term.x_name = "capstan_rad";
    term.x = {0.0, 1.0};
    term.y = {0.01, 0.02};
    return term;
}

TEST(DiagnosisJson, TheFormOfAnUnknownEffectIsWrittenAndReadBack) {
    EXPECT_TRUE(nlohmann::json::parse(diagnosis_json(example()))["unknown_term"].is_null());
    Diagnosis d;
    d.verdict = VerdictKind::kUnknown;
    d.unknown_terms = {ripple(), ripple()};
    d.unknown_terms[1].found.cause.side = "agonist";
    const std::string text = diagnosis_json(d);
    const nlohmann::json term = nlohmann::json::parse(text)["unknown_term"];
    EXPECT_EQ(term["port"], "motor");
    EXPECT_EQ(term["depends_on"], "angle");
    EXPECT_EQ(term["parameter"]["value"], 0.04);
    EXPECT_EQ(term["extra"]["per_rad"], 8.0);
    EXPECT_EQ(term["curve"]["y"][1], 0.02);
    EXPECT_EQ(term["second"]["side"], "agonist");
    const Diagnosis read = parse_diagnosis(text, "x");
    ASSERT_EQ(read.unknown_terms.size(), 2U);
    EXPECT_EQ(read.unknown_terms[0].found.cause, d.unknown_terms[0].found.cause);
    EXPECT_EQ(read.unknown_terms[0].found.extra, d.unknown_terms[0].found.extra);
    EXPECT_EQ(read.unknown_terms[1].found.parameter.value, 0.04);
    EXPECT_EQ(read.unknown_terms[0].port, "motor");
    const std::string other = R"({"effects": [], "unknown_term": {"id": "term.moon", "parameter": {"value": 1}}})";
    EXPECT_THROW((void)parse_diagnosis(other, "x"), core::InvalidInput);
}

TEST(DiagnosisJson, HasTheKeysThatOthersRead) {
    const nlohmann::json j = nlohmann::json::parse(diagnosis_json(example()));
    EXPECT_EQ(j["verdict"], "identified");
    EXPECT_EQ(j["effects"][0]["id"], "gear.coulomb");
    EXPECT_EQ(j["effects"][0]["side"], "agonist");
    EXPECT_EQ(j["effects"][0]["probability"], 0.98);
    EXPECT_EQ(j["effects"][0]["parameter"]["value"], 0.1 + 0.2);
    EXPECT_EQ(j["effects"][0]["parameter"]["ci95"], (nlohmann::json{0.25, 0.35}));
    EXPECT_EQ(j["effects"][0]["parameter"]["unit"], "Nm");
    EXPECT_EQ(j["alternatives"][0]["effects"], nlohmann::json::array());
    EXPECT_EQ(j["alternatives"][1]["effects"][0]["id"], "joint.coulomb");
    EXPECT_EQ(j["where"][0]["region"], (nlohmann::json{{"variable", "cocontraction_Nm"}, {"from", 0.12}, {"to", 0.5}}));
    EXPECT_EQ(j["gap"]["before"], 9.1);
    EXPECT_EQ(j["gap"]["unit"], "sigma");
    EXPECT_TRUE(j["gap"]["heldout_after"].is_null());
    EXPECT_EQ(j["next_experiment"], "break-away at 0.2 Nm");
    for (const char* key : {"build", "experiments", "map", "ranking", "isolability", "power", "next", "remarks", "case", "case_sha256"})
        EXPECT_TRUE(j.contains(key)) << key;
    EXPECT_FALSE(j.contains("traces"));
    EXPECT_TRUE(j["ranking"][0]["left_out"].is_null());
    EXPECT_EQ(j["transfer"][0]["effects"][0]["id"], "law.series");
    EXPECT_EQ(j["transfer"][0]["heldout"], "b.csv");
    EXPECT_EQ(j["transfer"][0]["heldout_after"], 7.9);
    EXPECT_EQ(j["transfer"][0]["parameters"][0]["value"], 9e-4);
    EXPECT_EQ(j["power"][0]["id"], "loop.delay");
    EXPECT_TRUE(j["power"][0]["least"].is_null());
    EXPECT_EQ(j["power"][0]["usual"], 0.02);
}

TEST(DiagnosisJson, AnEmptyOneHasEmptyLists) {
    const nlohmann::json j = nlohmann::json::parse(diagnosis_json({}));
    EXPECT_EQ(j["verdict"], "none");
    for (const char* key : {"effects", "alternatives", "where"}) EXPECT_EQ(j[key], nlohmann::json::array()) << key;
}

TEST(DiagnosisJson, GivesAPredictionBackWhatItNeeds) {
    const Diagnosis read = parse_diagnosis(diagnosis_json(example()), "d.json");
    ASSERT_EQ(read.effects.size(), 2u);
    EXPECT_EQ(read.verdict, VerdictKind::kIdentified);
    EXPECT_EQ(read.effects[0].cause, (effects::Cause{"gear.coulomb", "agonist"}));
    EXPECT_EQ(read.effects[0].parameter.value, 0.1 + 0.2);
    EXPECT_EQ(read.effects[0].parameter.ci95.high, 0.35);
    EXPECT_TRUE(std::isnan(read.effects[1].parameter.ci95.low));
    EXPECT_EQ(read.effects[1].extra, (std::vector<std::pair<std::string, double>>{{"velocity", 0.05}}));
    ASSERT_EQ(read.build.size(), 1u);
    EXPECT_EQ(read.build[0].first, "radius_ratio");
    EXPECT_EQ(read.build[0].second.value, 1.002);
    EXPECT_EQ(read.case_sha256, "00ff");
    for (const VerdictKind verdict : {VerdictKind::kNone, VerdictKind::kAmbiguous, VerdictKind::kUnknown}) {
        Diagnosis d;
        d.verdict = verdict;
        EXPECT_EQ(parse_diagnosis(diagnosis_json(d), "d.json").verdict, verdict);
    }
}

TEST(DiagnosisJson, EffectsAloneAreEnough) {
    const Diagnosis read = parse_diagnosis(R"({"effects": [{"id": "joint.coulomb", "parameter": {"value": 0.02}}]})", "d.json");
    EXPECT_EQ(read.verdict, VerdictKind::kIdentified);
    EXPECT_EQ(read.effects[0].cause.side, "none");
    EXPECT_EQ(parse_diagnosis(R"({"effects": []})", "d.json").verdict, VerdictKind::kNone);
}

TEST(DiagnosisJson, RefusalsNameTheKey) {
    const auto refusal = [](const std::string& json) -> std::string {
        try {
            (void)parse_diagnosis(json, "d.json");
        } catch (const core::InvalidInput& e) {
            return e.what();
        }
        return "accepted";
    };
    const auto expect = [&](const std::string& json, const std::string& words) {
        EXPECT_NE(refusal(json).find(words), std::string::npos) << refusal(json);
    };
    expect("{", "d.json:1:2: JSON: not valid JSON");
    expect("[]", "d.json: diagnosis: [] (allowed: an object)");
    expect(R"({"effects": [{"id": "a", "parameter": {"value": 1e400}}]})", "d.json:1:49: JSON: 1e400 (allowed: a number of at most");
    expect(std::string(100'000, '['), "d.json:1:65: JSON: nested 65 deep or more");
    expect(R"({"effects": [], "efects": []})", "diagnosis.efects: unknown key (allowed: verdict, effects");
    expect(R"({"effects": [{"id": "a", "value": 1, "parameter": {"value": 1}}]})", "effects[0].value: unknown key (allowed: id, side");
    expect(R"({"effects": [{"id": "a", "parameter": {"value": 1, "size": 2}}]})", "effects[0].parameter.size: unknown key");
    expect(R"({"effects": [{"id": "a", "probability": 1.5, "parameter": {"value": 1}}]})", "probability: 1.5 (allowed: 0 to 1)");
    expect("{}", "diagnosis.effects: missing");
    expect(R"({"effects": {}})", "diagnosis.effects: {} (allowed: an array)");
    expect(R"({"effects": [{"id": 3}]})", "diagnosis.effects[0].id: 3 (allowed: a text)");
    expect(R"({"effects": [{"id": "a", "parameter": {"value": null}}]})", "effects[0].parameter.value: null (allowed: a number)");
    expect(R"({"effects": [{"id": "a", "parameter": {"value": 1, "ci95": [1]}}]})", "ci95");
    expect(R"({"effects": [], "verdict": "maybe"})", "diagnosis.verdict: \"maybe\" (allowed: identified");
    expect(R"({"effects": [], "build": [1]})", "diagnosis.build: [1] (allowed: an object)");
}

}  // namespace
}  // namespace fusee::diagnosis
