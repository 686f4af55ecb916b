#include <algorithm>
#include <cmath>
#include <string>

#include "diagnosis/page.h"
#include "fusee/report/diagnosis.h"
#include "page/html.h"
#include "page_structure.h"
#include "report/diagnosis_fixture.h"

namespace fusee::report {
namespace {

/// The data of the first path of a class.
std::string path_of(const std::string& page, const std::string& css) {
    const std::string begin = "class=\"" + css + "\" d=\"";
    const auto at = page.find(begin);
    if (at == std::string::npos) return "";
    return page.substr(at + begin.size(), page.find('"', at + begin.size()) - at - begin.size());
}

TEST(DiagnosisHtml, AnswersWhereWhichAndHowFarInThisOrder) {
    const diagnosis::Diagnosis d = diagnosis();
    const std::string page = diagnosis_html(d);
    expect_page(page);
    EXPECT_EQ(elements(page, "h2").size(), 9u);
    std::size_t last = 0;
    for (const std::string& html : {trace_section(d), where_section(d), place_section(d), which_section(d), isolability_section(d)}) {
        EXPECT_GT(page.find(html), last);
        last = page.find(html);
        ASSERT_NE(last, std::string::npos);
    }
    expect_all(page,
               {"verdict pass-tag", "9.12 \u2192 1.04 sigma", "9.31 \u2192 1.06 sigma", "after: 0.97 to 1.17", "0.0512", "0.0473 to 0.0551",
                "-0.21", "62 %", "agonist, push up", ">found<", "motor torque [Nm]: 0.02, 0.05, 0.1", "Leaving out the time log"});
}

TEST(DiagnosisHtml, AnAmbiguousVerdictMarksTheMostProbableCauseToo) {
    diagnosis::Diagnosis d = diagnosis();
    d.verdict = diagnosis::VerdictKind::kAmbiguous;
    d.effects.resize(1);
    d.alternatives = {{{{"gear.stribeck", "agonist"}}, 0.3}};
    const Marked marked = marked_causes(d);
    EXPECT_TRUE(marked.found.empty());
    EXPECT_EQ(marked.possible, (std::vector<effects::Cause>{{"gear.coulomb", "agonist"}, {"gear.stribeck", "agonist"}}));
    expect_all(place_section(d), {"none is certain", "gear.coulomb (agonist): ", "gear.stribeck (agonist): "});
}

TEST(DiagnosisHtml, TheFormOfAnUnknownEffectIsASentenceALawAndACurve) {
    diagnosis::Diagnosis d = diagnosis();
    EXPECT_EQ(form_section(d), "");
    d.verdict = diagnosis::VerdictKind::kUnknown;
    d.effects.clear();
    diagnosis::UnknownTerm& term = d.unknown_terms.emplace_back();
    term.found = {{"term.motor.ripple", "antagonist"}, 0.97, {0.04, {0.03, 0.05}, "Nm"}, {{"per_rad", 1.91}, {"phase", 0.5}}};
    term.port = "motor";
    term.depends_on = "angle";
    term.law = "The motor torque has a sin(n theta + p) more.";
    term.sentence = "The torque of the antagonist's motor ripples 12 times a turn of its capstan, by 0.04 Nm.";
    term.x_name = "capstan_rad";
    term.y_name = "torque_Nm";
    term.x = {0.0, 1.0, 2.0};
    term.y = {0.01, -0.02, 0.03};
    expect_all(form_section(d), {"motor ripples 12 times a turn of its capstan, by 0.04 Nm.", "enters at the motor", "capstan angle [rad]",
                                 "torque [Nm]", "<svg", "per_rad", "0.97"});
    expect_all(diagnosis_html(d), {"Cause unknown", "but its form is known", "motor ripples 12 times"});
    EXPECT_NE(diagnosis_text(d).find(term.sentence), std::string::npos);
}

TEST(DiagnosisHtml, SaysOnWhichHeldOutFileAnEffectFails) {
    diagnosis::Diagnosis d = diagnosis();
    EXPECT_EQ(transfer_section(d), "");
    d.transfer = {{{{"law.series", "none"}}, "a.csv", "b.csv", 10.4, 3.0, 6.9, 7.9, {{9e-4, {}, "rad/Nm"}}, "Nm"},
                  {{{"law.scale", "none"}}, "a.csv", "b.csv", 10.4, 4.2, 6.9, 3.5, {{-0.24, {}, ""}}, "Nm"}};
    const std::string html = transfer_section(d);
    EXPECT_TRUE(holds(diagnosis_html(d), html));
    const std::vector<std::string> cells = elements(html, "td");
    ASSERT_EQ(cells.size(), 10u);
    EXPECT_EQ(cells[3], "b.csv: 6.9 \u2192 7.9");
    EXPECT_EQ(cells[4], "worse");
    EXPECT_EQ(cells[9], "better");
}

TEST(DiagnosisHtml, EscapesEveryText) {
    diagnosis::Diagnosis d = diagnosis();
    const std::string evil = "<i>&\"";
    d.case_name = d.case_sha256 = d.next_experiment = evil;
    d.effects[0].cause = {evil, evil};
    d.effects[0].parameter.unit = evil;
    d.effects[1].extra = {{evil, 1.0}};
    d.alternatives[0].effects[0].id = evil;
    d.where[0] = {evil, 0.5, evil, {0, 1}, evil};
    d.build[0] = {evil, {1.0, {0, 2}, evil}};
    d.experiments[0].experiment = d.map[0].experiment = d.map[0].variable = evil;
    d.ranking[0].effects[0].id = d.ranking[0].parameters[0].unit = evil;
    d.isolability.causes[0].id = d.isolability.units[1] = evil;
    d.traces[0].experiment = d.traces[0].label = d.traces[0].x_name = d.traces[0].y_name = evil;
    d.transfer = {{{{evil, "none"}}, evil, evil, 1.0, 1.0, 1.0, 1.0, {{1.0, {}, evil}}, evil}};
    d.next[0].text = d.next[0].experiment = d.next[0].variable = d.remarks[0] = evil;
    const std::string page = diagnosis_html(d);
    EXPECT_FALSE(holds(page, "<i>"));
    EXPECT_FALSE(holds(page, "&\""));
    EXPECT_GT(occurrences(page, "&lt;i&gt;&amp;&quot;"), 20u);
}

TEST(DiagnosisHtml, AnEmptyDiagnosisHasAHeadAndNothingElse) {
    const std::string page = diagnosis_html({});
    EXPECT_TRUE(holds(page, "verdict pass-tag"));
    EXPECT_TRUE(holds(page, "<b>\u2013 \u2192 \u2013 sigma</b>"));
    EXPECT_EQ(occurrences(page, "<section"), 0u);
    EXPECT_EQ(occurrences(page, "<table"), 0u);
    expect_page(page);
}

TEST(DiagnosisHtml, FiguresThatAreNotKnownAreDashes) {
    diagnosis::Diagnosis d = diagnosis();
    const double unknown = diagnosis::kNoFigure;
    d.gap = {};
    d.effects[0].parameter = {unknown, {unknown, unknown}, "Nm"};
    d.experiments[0].gap = {};
    d.experiments[0].forecast = unknown;
    for (diagnosis::Hypothesis& h : d.ranking) h.log_evidence = -INFINITY, h.chi2 = h.left_out = h.probability = unknown;
    d.isolability.detectable[0] = INFINITY;
    d.isolability.signature_similarity[3][2] = unknown;
    d.next[0].information = unknown;
    const std::string page = diagnosis_html(d);
    expect_page(page);
    EXPECT_GT(occurrences(page, "\u2013"), 20u);
}

TEST(DiagnosisHtml, TakesAFurtherSectionAsItIs) {
    const std::string extra = section("The loop closed", "<p>dead-band</p>");
    const std::string page = diagnosis_html(diagnosis(), extra);
    EXPECT_TRUE(holds(page, extra));
}

TEST(DiagnosisHtml, ThirtyLongTracesStayBelow2MB) {
    diagnosis::Diagnosis d = diagnosis();
    d.traces.assign(30, log_trace("log", 400));
    const std::string thirty = diagnosis_html(d);
    EXPECT_LT(thirty.size(), 2'000'000u);
    d.traces.assign(90, log_trace("log", 100'000));
    const std::string ninety = diagnosis_html(d);
    EXPECT_LT(ninety.size(), 2'000'000u);
}

TEST(GapMap, IsAStripForEachExperimentBeforeAndAfter) {
    diagnosis::Diagnosis d;
    d.map = {{"dead_band", "cocontraction_Nm", {0.3, 0.5}, 2.4, 1.1, 5}, {"dead_band", "cocontraction_Nm", {0.1, 0.3}, 27.0, 0.8, 5}};
    const std::string html = where_section(d);
    for (const char* cell : {"fill=\"#8c2d04\"", "fill=\"#fec44f\"", "fill=\"#fff7bc\"", "fill=\"#ffffe5\""})
        EXPECT_EQ(occurrences(html, cell), 2u) << cell << ": one cell, one key of the legend";
    EXPECT_LT(html.find(">27<"), html.find(">2.4<")) << "by rising range";
    EXPECT_EQ(occurrences(html, ">0.3</text>"), 2u) << "an edge that two cells share is shown once in each map";
    EXPECT_EQ(occurrences(html, ">dead-band</text>"), 2u);
}

TEST(GapMap, FoldsLongStripsAndNamesRangesThatDoNotTouch) {
    diagnosis::Diagnosis d;
    for (int i = 0; i < 30; ++i) d.map.push_back({"log", "t_s", {i + 0.0, i + 1.0}, 1.0, 1.0, 9});
    EXPECT_EQ(occurrences(where_section(d), ">time log</text>"), 2u * 4u);
    d.map = {{"dead_band", "cocontraction_Nm", {0.1, 0.1}, 1, 1, 3}, {"dead_band", "cocontraction_Nm", {0.5, 0.8}, 1, 1, 3}};
    EXPECT_EQ(occurrences(where_section(d), ">0.5\u20130.8</text>"), 2u);
}

TEST(IsolabilityMatrix, OutlinesPairsOfAClass) {
    diagnosis::Diagnosis d;
    d.isolability = isolability();
    const std::string html = isolability_section(d);
    EXPECT_EQ(occurrences(html, "stroke-width=\"2\""), 1u + 3u) << "a pair, and three pairs of three";
    EXPECT_EQ(occurrences(html, "<rect"), 16u * 15u / 2u + 8u) << "the lower triangle and the legend";
    EXPECT_TRUE(holds(html, "<li>gear.load_friction (agonist), sensor.torque_scale (agonist)</li>"));
    EXPECT_TRUE(holds(html, ">98</text>"));
    d.isolability.classes.clear();
    EXPECT_EQ(occurrences(isolability_section(d), "<li>"), 0u);
}

TEST(IsolabilityMatrix, StaysBoundedForManyCauses) {
    diagnosis::Diagnosis d;
    d.isolability.causes.assign(200, {"gear.coulomb", "agonist"});
    d.isolability.signature_similarity.assign(200, std::vector<double>(200, 0.5));
    const std::string html = isolability_section(d);
    EXPECT_TRUE(holds(html, "72 of 200"));
    EXPECT_LT(html.size(), 600'000u);
}

TEST(TraceChart, RepeatsAreOneCurveAndALoopKeepsItsTwoBranches) {
    diagnosis::Diagnosis d;
    d.traces = {repeat_trace("levels three times over")};
    const std::string repeats = trace_section(d);
    EXPECT_EQ(occurrences(repeats, "class=\"band se\""), 1u);
    d.traces = {loop_trace("there and back")};
    const std::string loop = trace_section(d);
    EXPECT_EQ(occurrences(loop, "class=\"band se\""), 3u) << "up, down over zero, up to zero";
    const std::string after = path_of(loop, "curve se");
    EXPECT_EQ(std::count(after.begin(), after.end(), 'M'), 1);
    EXPECT_EQ(std::count(after.begin(), after.end(), 'L'), 80);
}

TEST(TraceChart, ANewSweepBeginsANewLine) {
    diagnosis::Trace sweeps{"breakaway", "two motors", "x", "y", {}, {}, {}, {}, {}};
    for (const double shift : {0.0, 5.0})
        for (int i = 0; i < 10; ++i) {
            sweeps.x.push_back(i);
            sweeps.measured.push_back(i + shift);
            sweeps.after.push_back(i + shift);
            sweeps.sigma.push_back(0.1);
        }
    diagnosis::Diagnosis d;
    d.traces = {sweeps};
    const std::string html = trace_section(d), after = path_of(html, "curve se");
    EXPECT_EQ(std::count(after.begin(), after.end(), 'M'), 2) << after;
    EXPECT_EQ(occurrences(html, "class=\"band se\""), 2u);
    EXPECT_EQ(path_of(html, "curve pe dashed"), "") << "no prediction before, no line";
}

TEST(TraceChart, ManyCyclesKeepTheirPathAndScatterIsSorted) {
    diagnosis::Trace cycles{"force_loop", "many cycles", "x_m", "F_N", {}, {}, {}, {}, {}}, scatter = cycles;
    for (int i = 0; i < 400; ++i) {
        cycles.x.push_back(std::sin(0.2 * i));  // 25 turns
        cycles.after.push_back(std::cos(0.2 * i));
        cycles.sigma.push_back(0.1);
    }
    scatter.x = scatter.after = {0, 5, 1, 6, 2, 7, 3, 8, 4, 9, 0.5, 5.5, 1.5, 6.5, 2.5, 7.5, 3.5, 8.5, 4.5, 9.5};
    scatter.sigma.assign(scatter.x.size(), 0.1);
    diagnosis::Diagnosis d;
    d.traces = {cycles};
    const std::string path = trace_section(d);
    EXPECT_EQ(occurrences(path, "class=\"band se\""), 0u);
    EXPECT_GT(occurrences(path_of(path, "curve se"), "L"), 390u);
    d.traces = {scatter};
    const std::string sorted = trace_section(d);
    EXPECT_EQ(occurrences(sorted, "class=\"band se\""), 1u);
    // From the lowest left to the highest right: never back down, so drawn heights only fall.
    const std::string line = path_of(sorted, "curve se");
    double last = 1e9;
    for (std::size_t at = line.find(' '); at != std::string::npos; at = line.find(' ', at + 1)) {
        const double height = std::stod(line.substr(at));
        EXPECT_LT(height, last);
        last = height;
    }
}

TEST(TraceChart, TheBandIs95PerCentWide) {
    diagnosis::Trace flat{"log", "flat", "t_s", "y", {0, 1}, {0, 0}, {0, 0}, {0, 0}, {1, 1}};
    diagnosis::Diagnosis d;
    d.traces = {flat};
    // The axis goes from -2 to 2 over 220 units: 300 less 46 for the axis and 34 for the legend.
    const std::string band = path_of(trace_section(d), "band se");
    const double low = std::stod(band.substr(band.find(' '))), high = std::stod(band.substr(band.rfind(' ')));
    EXPECT_NEAR((low - high) / 2.0, 1.959964 * 220.0 / 4.0, 1e-3);  // coordinates have three decimals
}

TEST(TraceChart, DrawsFewerPointsOfMoreTraces) {
    EXPECT_EQ(drawn_points(0), kMostPointsOfATrace);
    EXPECT_EQ(drawn_points(30), 400u);
    EXPECT_EQ(drawn_points(60), 200u);
    EXPECT_EQ(drawn_points(100'000), 20u);
}

}  // namespace
}  // namespace fusee::report
