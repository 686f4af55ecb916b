#include <algorithm>
#include <cmath>

#include "diagnosis/json.h"
#include "fusee/report/diagnosis.h"
#include "fusee/report/search.h"
#include "page_structure.h"
#include "report/diagnosis_fixture.h"

namespace fusee::report {
namespace {

TEST(DiagnosisJson, HoldsWhatProgramsAndThePageRead) {
    const diagnosis::Diagnosis d = diagnosis();
    const nlohmann::json json = nlohmann::json::parse(full_diagnosis_json(d)), plain = nlohmann::json::parse(diagnosis::diagnosis_json(d));
    for (const auto& [key, value] : plain.items()) EXPECT_EQ(json[key], value) << key;
    EXPECT_EQ(json["sentence"], "The rig has 2 effects that the model lacks: gear.coulomb (agonist) and se.radius (both).");
    EXPECT_EQ(json["probability"], 0.934);
    EXPECT_EQ(json["meanings"]["gear.load_friction"]["of_joint"], true) << "of an alternative";
    EXPECT_FALSE(json["meanings"]["se.radius"]["meaning"].get<std::string>().empty());
    EXPECT_EQ(json["traces"].size(), d.traces.size());
    EXPECT_EQ(diagnosis::parse_diagnosis(full_diagnosis_json(d), "d.json").effects.size(), 2u) << "fusee reads it again";
}

TEST(DiagnosisJson, TracesAreThinnedEvenlyAndKeepTheGapOfAllRows) {
    diagnosis::Trace trace{"log", "flat", "t_s", "y", {}, {}, {}, {}, {}};
    for (int i = 0; i < 1000; ++i) {
        trace.x.push_back(i < 3 ? diagnosis::kNoFigure : i);
        trace.measured.push_back(3.0);
        trace.before.push_back(1.0);
        trace.sigma.push_back(2.0);
    }
    trace.after = {3.0};
    const nlohmann::json json = traces_json({trace}).front();
    EXPECT_EQ(json["rows"], 1000u);
    EXPECT_EQ(json["x"].size(), 333u) << "every third row but the first, whose x is not known";
    EXPECT_EQ(json["x"][1], 6.0);
    EXPECT_TRUE(json["after"][0].is_null()) << "it has no such row";
    EXPECT_DOUBLE_EQ(json["explained"].get<double>(), 1000.0) << "(3 - 1)^2 / 2^2 of each row";
    EXPECT_EQ(drawn_points(0), kMostPointsOfATrace);
    EXPECT_EQ(drawn_points(30), 400u);
    EXPECT_EQ(drawn_points(60), 200u);
    EXPECT_EQ(drawn_points(100'000), 20u);
}

TEST(DiagnosisHtml, HoldsTheJsonTheSummaryAndTheNewCams) {
    const diagnosis::Diagnosis d = diagnosis();
    expect_shell(diagnosis_html(d), "diagnosis", full_diagnosis_json(d), diagnosis_text(d));
    EXPECT_TRUE(data_of(diagnosis_html(d), "redesign").is_null());
    EXPECT_EQ(data_of(diagnosis_html(d, redesign_json({})), "redesign"), nlohmann::json::parse(redesign_json({})));
    expect_shell(diagnosis_html({}), "diagnosis", full_diagnosis_json({}), "");
}

TEST(DiagnosisHtml, ManyLongTracesStayBelow2MB) {
    diagnosis::Diagnosis d = diagnosis();
    d.traces.assign(30, log_trace("log", 400));
    EXPECT_LT(diagnosis_html(d).size(), 2'000'000u);
    d.traces.assign(90, log_trace("log", 100'000));
    EXPECT_LT(diagnosis_html(d).size(), 2'000'000u);
}

TEST(DiagnosisText, AFormIsASentence) {
    diagnosis::Diagnosis d = diagnosis();
    d.verdict = diagnosis::VerdictKind::kUnknown;
    d.effects.clear();
    diagnosis::UnknownTerm& term = d.unknown_terms.emplace_back();
    term.found = {{"term.motor.ripple", "antagonist"}, 0.97, {0.04, {0.03, 0.05}, "Nm"}, {{"per_rad", 1.91}, {"phase", 0.5}}};
    term.sentence = "The torque of the antagonist's motor ripples 12 times a turn of its capstan, by 0.04 Nm.";
    EXPECT_NE(diagnosis_text(d).find(term.sentence), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(full_diagnosis_json(d))["term_units"][0].size(), 2u);
}

}  // namespace
}  // namespace fusee::report
