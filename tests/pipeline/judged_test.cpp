#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "fusee/batch/batch.h"
#include "fusee/pipeline/check.h"
#include "fusee/report/headline.h"
#include "pipeline/fixture.h"

// What was not judged is said, what was judged for another process too; a summary leads with what the user gets.
namespace fusee::pipeline {
namespace {

class Judged : public fixtures::TempFolder {
protected:
    [[nodiscard]] profile::Profile changed(const char* name, const fixtures::Changes& changes) const {
        lay_tables();
        return profile::read_profile(write("changed.toml", fixtures::with_keys(core::read_file(fixtures::shipped(name)), changes)));
    }
    [[nodiscard]] static core::Findings checked(const profile::Profile& profile, checks::ProcessKind kind = checks::ProcessKind::kFdm) {
        return check(profile, std::array{kind}).processes.front().all();
    }
    [[nodiscard]] static const core::Finding* find(const core::Findings& all, const std::string& rule, const std::string& where) {
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const core::Finding& f) { return f.rule == rule && f.where.starts_with(where); });
        return found == all.end() ? nullptr : &*found;
    }
};

const fixtures::Changes kSprings{{"cable.max_pressure_MPa", "200.0"},    {"k_se.spring.wire_mm", "1.0"},
                                 {"k_se.spring.coil_mm", "10.8"},        {"k_se.spring.active_coils", "20.0"},
                                 {"k_se.spring.free_length_mm", "40.0"}, {"k_se.spring.tensile_strength_MPa", "2000.0"},
                                 {"k_se.spring.max_angle_rad", "20.0"},  {"k_se.spring.max_torque_Nm", "1.0"},
                                 {"k_se.spring.hand", "\"right\""},      {"k_se.spring.rod_mm", "6.0"},
                                 {"k_se.spring.cycles", "1e5"},          {"k_pe.spring.wire_mm", "2.0"},
                                 {"k_pe.spring.coil_mm", "16.0"},        {"k_pe.spring.active_coils", "8.0"},
                                 {"k_pe.spring.free_length_mm", "70.0"}, {"k_pe.spring.tensile_strength_MPa", "2000.0"},
                                 {"k_pe.spring.rod_mm", "10.0"},         {"k_pe.spring.cycles", "1e5"},
                                 {"k_pe.spring.max_travel_mm", "50.0"},  {"k_pe.spring.max_force_N", "200.0"}};

const fixtures::Changes kUnstated{{"k_se.spring.wire_mm", "0"},
                                  {"k_se.spring.coil_mm", "0"},
                                  {"k_se.spring.active_coils", "0"},
                                  {"k_se.spring.free_length_mm", "0"},
                                  {"k_se.spring.max_angle_rad", "0"},
                                  {"k_se.spring.max_torque_Nm", "0"},
                                  {"k_se.spring.hand", "\"unknown\""},
                                  {"k_se.spring.rod_mm", "0"},
                                  {"k_se.spring.cycles", "0"},
                                  {"k_se.spring.wire_class", "\"unknown\""},
                                  {"k_pe.spring.wire_mm", "0"},
                                  {"k_pe.spring.coil_mm", "0"},
                                  {"k_pe.spring.active_coils", "0"},
                                  {"k_pe.spring.free_length_mm", "0"},
                                  {"k_pe.spring.max_travel_mm", "0"},
                                  {"k_pe.spring.max_force_N", "0"},
                                  {"k_pe.spring.rod_mm", "0"},
                                  {"k_pe.spring.cycles", "0"},
                                  {"k_pe.spring.wire_class", "\"unknown\""}};

// Springs without wire and strength: nothing of them passes in silence.
TEST_F(Judged, SpringsAreNotJudgedUntilTheirDataIsStated) {
    const core::Findings without = checked(changed("pnrvsa", kUnstated));
    for (const char* rule : {"spring.stress", "spring.fatigue", "spring.rod", "spring.index", "spring.rate", "spring.surge"})
        for (const char* part : {"k_se", "k_pe"}) {
            const core::Finding* f = find(without, rule, part);
            ASSERT_NE(f, nullptr) << rule << ' ' << part;
            EXPECT_EQ(f->severity, core::Severity::kNotJudged) << core::to_line(*f);
        }
    EXPECT_EQ(find(without, "spring.buckling", "k_pe")->suggestion.text(), "k_pe.spring.free_length_mm and k_pe.spring.coil_mm");
    EXPECT_EQ(find(without, "spring.buckling", "k_se"), nullptr) << "a torsion spring does not buckle";
    const core::Findings with = checked(changed("pnrvsa", kSprings));
    for (const core::Finding& f : with) EXPECT_NE(f.severity, core::Severity::kNotJudged) << core::to_line(f);
    for (const core::Finding& f : without) {
        if (f.severity != core::Severity::kNotJudged) continue;
        if (f.rule.starts_with("joint.spring_")) continue;  // these coils break rules, and a joint with such parts is not judged
        EXPECT_NE(find(with, f.rule, f.where.substr(0, 4)), nullptr) << f.rule;
    }
}

TEST_F(Judged, EachMissingKeyIsOneThatStatesTheData) {
    const core::Findings without = checked(changed("pnrvsa", kUnstated));
    std::set<std::string> stated;
    for (const auto& [key, value] : kSprings) stated.insert(key);
    for (const core::Finding& f : without) {
        if (f.severity != core::Severity::kNotJudged) continue;
        const bool known =
            std::any_of(stated.begin(), stated.end(), [&](const auto& key) { return f.suggestion.text().find(key) != std::string::npos; });
        EXPECT_TRUE(known) << core::to_line(f);
    }
}

const fixtures::Changes kCoarse{
    {"k_se.target_rows", "200"}, {"k_pe.target_rows", "200"}, {"tolerances.chordal_error_mm", "0.0025"}, {"outputs.pair", "false"}};

fixtures::Changes with(fixtures::Changes all, const fixtures::Changes& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

TEST_F(Judged, GCodeOfAPrintedProfileIsToReviewWithTheNumberOfRulesOfTheMill) {
    const profile::Profile profile = changed("pnrvsa", with(kCoarse, {{"outputs.formats", R"(["ngc"])"}}));
    const batch::MakeResult result = batch::make(profile, {.out = folder_ / "out"});
    ASSERT_TRUE(result.made);
    for (const auto& [part, mill] : {std::pair{"k_se", checks::ProcessKind::kMill}, std::pair{"k_pe", checks::ProcessKind::kMill4}}) {
        const core::Finding* f = find(result.findings, "toolpath.process", part);
        ASSERT_NE(f, nullptr) << part;
        EXPECT_EQ(f->severity, core::Severity::kWarning) << core::to_line(*f);
        EXPECT_NE(f->suggestion.text().find(std::string("--process ") + checks::to_string(mill) + " "), std::string::npos)
            << f->suggestion.text();
        const std::vector<CheckedPart> parts = check(profile, std::array{mill}).processes.front().parts;
        const core::Findings& of_mill = parts[part == std::string("k_se") ? 0 : 1].findings;
        EXPECT_EQ(f->measured, static_cast<double>(std::count_if(of_mill.begin(), of_mill.end(), core::is_broken)));
    }
    const batch::MakeResult no_code =
        batch::make(changed("pnrvsa", with(kCoarse, {{"outputs.formats", R"(["stl"])"}})), {.out = folder_ / "stl"});
    EXPECT_EQ(find(no_code.findings, "toolpath.process", ""), nullptr);
}

TEST_F(Judged, GCodeOfAMilledProfileIsNoMatter) {
    const batch::MakeResult milled = batch::make(
        changed("pnrvsa", with(kCoarse, {{"outputs.formats", R"(["ngc"])"}, {"process.kind", "\"mill\""}})), {.out = folder_ / "out"});
    ASSERT_TRUE(milled.made);
    EXPECT_EQ(find(milled.findings, "toolpath.process", ""), nullptr);
}

TEST_F(Judged, TheSummaryLeadsWithRangesOfWhatIsBuilt) {
    const batch::MakeResult result =
        batch::make(changed("pnrvsa", with(kCoarse, {{"outputs.formats", R"(["stl"])"}})), {.out = folder_ / "out"});
    ASSERT_TRUE(result.made);
    const auto head = report::head_figures(result.headline, result.file_errors);
    ASSERT_EQ(head.size(), 4u);
    EXPECT_EQ(head[0].value, "75.5 to 20.4 deg");
    EXPECT_NE(head[0].label.find("from 0.85 Nm to 1.5 Nm"), std::string::npos) << head[0].label;
    EXPECT_NE(head[0].label.find("62 to 83.2 deg at 0.85 Nm"), std::string::npos) << head[0].label;
    EXPECT_EQ(head[1].value, "-12.6 to +11.3 %");
    EXPECT_NE(head[1].label.find("worst-case torque error of either spring as built by fdm"), std::string::npos) << head[1].label;
    EXPECT_NE(head[1].label.find("k_pe: -12.4 to +11.2 %), from contour 10.7 %, rate 8.2 %"), std::string::npos) << head[1].label;
    EXPECT_EQ(head[2].value, "0.151 Nm");
    EXPECT_EQ(head[3].value, "within rounding (-2e-06 to -6.4e-07)");
}

TEST_F(Judged, ATableOfMeasuredTorquesStandsInTheReport) {
    const profile::Profile profile = changed("measured_table", with(kCoarse, {{"outputs.formats", R"(["stl"])"}}));
    const batch::MakeResult result = batch::make(profile, {.out = folder_ / "out"});
    ASSERT_TRUE(result.made);
    const auto table = nlohmann::json::parse(core::read_file(result.folder / "report.json"))["law"]["table"];
    const auto& pair = std::get<profile::TablePair>(profile.law.curves);
    ASSERT_EQ(table["rows"].size(), pair.angle.size());
    double squares = 0.0;
    for (std::size_t i = 0; i < pair.angle.size(); ++i) {
        EXPECT_EQ(table["rows"][i][1], pair.series[i]);
        const double residual = table["rows"][i][2].get<double>() - pair.series[i];
        EXPECT_LT(std::abs(residual), 0.02) << "noise of 2 mNm";
        squares += residual * residual;
    }
    const double rms = table["series"]["rms_Nm"];
    EXPECT_NEAR(rms, std::sqrt(squares / static_cast<double>(pair.angle.size())), 1e-12);
    EXPECT_GT(rms, 1e-3);
    EXPECT_LT(rms, 3e-3);
}

TEST_F(Judged, MakingResolvesTheProfileOnce) {
    // No rule objects: no suggestion is judged, each of which is a profile of its own.
    const profile::Profile profile = changed("measured_table", with(kCoarse, {{"outputs.formats", R"(["stl"])"}}));
    const std::size_t before = resolve_count();
    EXPECT_TRUE(batch::make(profile, {.out = folder_ / "out"}).made);
    EXPECT_EQ(resolve_count(), before + 1);
}

}  // namespace
}  // namespace fusee::pipeline
