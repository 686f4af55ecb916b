#include "fusee/batch/study.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>

#include "fusee/checks/check.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/make.h"
#include "fusee/study/store.h"
#include "pipeline/fixture.h"
#include "refused.h"

namespace fusee::batch {
namespace {

namespace fs = std::filesystem;

class Studies : public fixtures::TempFolder {
protected:
    /// The shipped joint with a coarse mesh; its files, where a study writes them, are STL: what a study does is the same for every format.
    static std::string quick_design() {
        return fixtures::with_keys(
            core::read_file(fixtures::shipped("pnrvsa")),
            {{"tolerances.chordal_error_mm", "0.005"}, {"outputs.springs_rows", "200"}, {"outputs.formats", "[\"stl\"]"}});
    }
    /// Four designs of the shipped joint with a coarse mesh; one of them is refused: a bore that leaves no wall.
    study::Plan plan(const std::string& outputs = "figures") const {
        write("base.toml", quick_design());
        const fs::path file = write("four.toml", "[study]\nbase = \"base.toml\"\noutputs = \"" + outputs +
                                                     "\"\n[vary]\nk_se.hub.bore_mm = [5.0, 6.0, 60.0]\ncable.diameter_mm = [0.8, 0.9]\n"
                                                     "[constraints]\nfew = \"k_se.hub.bore_mm < 50 || cable.diameter_mm < 0.85\"\n");
        return study::Plan(study::read_study(file));
    }
    StudyResult run(const study::Plan& plan, const std::string& out, Shard shard = {}, unsigned jobs = 2) const {
        return run_study(plan, {.out = folder_ / out, .jobs = jobs, .shard = shard});
    }
    static std::vector<std::string> lines_of(const std::string& text) {
        std::vector<std::string> lines;
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        return lines;
    }
    /// Every file of a study but the log of its rows, which has times.
    std::map<std::string, std::string> bytes(const std::string& out) const {
        std::map<std::string, std::string> all;
        const fs::path root = folder_ / out / "four";
        for (const auto& entry : fs::recursive_directory_iterator(root)) {
            const std::string name = fs::relative(entry.path(), root).generic_string();
            if (entry.is_regular_file() && !name.starts_with("rows/")) all[name] = core::sha256_hex(core::read_file(entry.path()));
        }
        return all;
    }
};

TEST_F(Studies, EachDesignIsARowAndARefusalOneWithItsReason) {
    const StudyResult result = run(plan(), "out");
    EXPECT_EQ(result.planned, 6U);
    EXPECT_EQ(result.excluded, 1U);
    EXPECT_EQ(result.made, 4U);
    EXPECT_EQ(result.refused, 1U);
    EXPECT_EQ(result.indexed, 5U);
    EXPECT_EQ(exit_code(result), 0);
    std::vector<std::string> lines;
    study::query(folder_ / "out/four/index.sqlite", "SELECT outcome, worst_rule, k_se_hub_bore_mm FROM designs WHERE outcome <> 'made'",
                 std::chrono::seconds(60), [&](const auto& cells) {
                     lines.push_back(cells[0] + " " + cells[1] + " " + cells[2]);
                     return true;
                 });
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_TRUE(lines[1].starts_with("refused ") && lines[1].ends_with(" 60.0")) << lines[1];
}

// Figures alone write no file and take nothing from one: every figure of the designs is that of the study with files.
TEST_F(Studies, ASingleSpringHasFiguresOfItsOwn) {
    write("base.toml", fixtures::with_key(core::read_file(fixtures::shipped("single/hardening")), "tolerances.chordal_error_mm", "0.02"));
    const fs::path file = write("four.toml",
                                "[study]\nbase = \"base.toml\"\noutputs = \"figures\"\n[vary]\n"
                                "cam.spring.preload_mm = [2.0, 16.0]\n");
    const study::Plan plan(study::read_study(file));
    EXPECT_TRUE(plan.has_springs() && !plan.has_joints());
    const StudyResult result = run(plan, "out");
    EXPECT_EQ(result.made, 1U);
    EXPECT_EQ(result.refused, 1U);
    EXPECT_EQ(exit_code(result), 0);
    std::vector<std::string> cells;
    study::query(folder_ / "out/four/index.sqlite",
                 "SELECT torque_least_Nm, torque_greatest_Nm, torque_error_built_percent, spring_stress_percent, spring_fatigue_safety, "
                 "volume_cm3, cam_x_mm FROM designs WHERE outcome = 'made'",
                 std::chrono::seconds(60), [&](const auto& row) {
                     cells = row;
                     return true;
                 });
    ASSERT_EQ(cells.size(), 7U);
    const double end = core::rad_from_deg(35.0), torque = 0.8 * end + 5.0 * end * end * end;
    EXPECT_NEAR(std::stod(cells[0]), -torque, 1e-9);
    EXPECT_NEAR(std::stod(cells[1]), torque, 1e-9);
    EXPECT_GT(std::stod(cells[2]), 8.0) << "the rate alone is within 8.2 %";
    EXPECT_LT(std::stod(cells[3]), 100.0);
    EXPECT_GT(std::stod(cells[4]), 1.0);
    EXPECT_GT(std::stod(cells[5]), 10.0);
    EXPECT_GT(std::stod(cells[6]), 60.0);
}

TEST_F(Studies, FiguresAreThoseOfTheStudyWithFiles) {
    const char* scratch = std::getenv("TMPDIR");
    const std::string before = scratch != nullptr ? scratch : "";
    ::setenv("TMPDIR", (folder_ / "gone").c_str(), 1);  // no temporary folder is needed
    EXPECT_EQ(run(plan("figures"), "figures").made, 4U);
    scratch != nullptr ? ::setenv("TMPDIR", before.c_str(), 1) : ::unsetenv("TMPDIR");
    EXPECT_FALSE(fs::exists(folder_ / "figures/four/designs"));
    EXPECT_EQ(run(plan("meshes"), "meshes").made, 4U);
    EXPECT_TRUE(fs::exists(folder_ / "meshes/four/designs"));
    const auto rows = [&](const char* out) {
        std::vector<std::vector<std::string>> all;
        study::query(
            folder_ / out / "four/index.sqlite",
            "SELECT outcome, dead_band_least_deg, dead_band_overdrive_deg, dead_band_built_high_deg, joint_torque_Nm, condition_6, "
            "shop_arm_error_percent, mass_g, k_se_triangles, k_pe_triangles, warnings, not_judged, worst_finding FROM designs",
            std::chrono::seconds(60), [&](const auto& cells) {
                all.emplace_back(cells.begin(), cells.end());
                return true;
            });
        return all;
    };
    EXPECT_EQ(rows("figures").size(), 6U) << "the heads and five designs";
    EXPECT_EQ(rows("figures"), rows("meshes"));
}

// A bore of 60 mm leaves K_SE no wall: no rule that needs a mesh is asked then, neither of K_SE nor of K_PE.
TEST_F(Studies, CheapRulesRefuseBeforeAnythingIsMeshed) {
    const study::Plan four = plan();
    const auto refused = pipeline::make_figures(four.profile(four.at(4)));
    ASSERT_FALSE(refused);
    EXPECT_TRUE(core::any_error(refused.refusal()));
    for (const core::Finding& finding : refused.refusal()) {
        const checks::Rule* rule = checks::find_rule(finding.rule);
        EXPECT_FALSE(rule != nullptr && rule->needs_mesh) << finding.rule;
    }
    EXPECT_TRUE(pipeline::make_figures(four.profile(four.at(0))));
}

TEST_F(Studies, BytesAreTheSameForAnyJobsAndShards) {
    const study::Plan four = plan("meshes");
    EXPECT_EQ(run(four, "one", {}, 1).made, 4U);
    (void)run(four, "two", {}, 2);
    EXPECT_EQ(bytes("one"), bytes("two"));
    for (const std::size_t number : {2U, 3U, 1U}) EXPECT_EQ(run(four, "sharded", {number, 3}).indexed, 0U);
    EXPECT_EQ(write_index(four, folder_ / "sharded", false).designs, 5U);
    EXPECT_EQ(bytes("one"), bytes("sharded"));
}

TEST_F(Studies, WhatIsFinishedIsNotMadeAgain) {
    const study::Plan four = plan();
    (void)run(four, "out", {1, 2});
    const auto before = run(four, "out");
    EXPECT_EQ(before.earlier, 3U);
    EXPECT_EQ(before.made + before.refused, 2U);
    const auto all = bytes("out");
    const auto after = run(four, "out");
    EXPECT_EQ(after.earlier, 5U);
    EXPECT_EQ(after.made + after.refused, 0U);
    EXPECT_EQ(bytes("out"), all);
}

TEST_F(Studies, AProfileThatIsGoneIsOneFaultAndTheRestGoesOn) {
    const fs::path good = write("good.toml", quick_design());
    const study::Plan two(study::study_of({folder_ / "gone.toml", good}, "four"));
    const StudyResult result = run(two, "out");
    EXPECT_EQ(result.made, 1U);
    EXPECT_EQ(result.bad_input, 1U);
    ASSERT_EQ(result.reasons.size(), 1U);
    EXPECT_NE(result.reasons[0].find("gone.toml"), std::string::npos);
    EXPECT_EQ(exit_code(result), 2);
    EXPECT_EQ(result.indexed, 1U);
}

TEST_F(Studies, TwoKeysWithTheSameValueAreTwoDesigns) {
    const auto one = [&](const char* key) {
        write("base.toml", quick_design());
        const fs::path file = write("four.toml", std::string("[study]\nbase = \"base.toml\"\noutputs = \"figures\"\nmethod = \"random\"\n"
                                                             "count = 1\n[vary]\n") +
                                                     key + " = [6.0]\n");
        return study::Plan(study::read_study(file));
    };
    EXPECT_EQ(run(one("k_se.hub.bore_mm"), "out").made, 1U);
    const StudyResult other = run_study(one("k_pe.hub.bore_mm"), {.out = folder_ / "out", .jobs = 1, .shard = {}, .force = true});
    EXPECT_EQ(other.earlier, 0U);
    EXPECT_EQ(other.made, 1U);
}

TEST_F(Studies, AFolderOfDesignsHasTheNameOfItsRow) {
    const std::string text = quick_design();
    const study::Plan two(study::study_of({write("left.toml", text), write("right.toml", text)}, "four"));
    EXPECT_EQ(run(two, "out").made, 2U);
    for (const char* name : {"left", "right"}) EXPECT_TRUE(fs::exists(folder_ / "out/four/designs" / name / "report.html")) << name;
}

// A changed row, one of another program, of other inputs and of another design: said, and their designs are made again.
TEST_F(Studies, BadRowsAreNamedAndMadeAgain) {
    (void)run(plan(), "out");
    const auto before = bytes("out");
    const fs::path log = folder_ / "out/four/rows/1-of-1.jsonl";
    std::vector<std::string> lines = lines_of(core::read_file(log));
    ASSERT_EQ(lines.size(), 5U);
    lines[0].replace(lines[0].find("\"made\""), 6, "\"mude\"");
    lines[1] = R"({"key":"zzz)";
    lines[2] = std::string(300, '\0');
    lines.push_back(study::to_json_line({core::sha256_hex("other"), 1, "pnrvsa", {{"outcome", "made"}}, 0.0}));
    std::string text;
    for (const std::string& line : lines) text += line.ends_with('\n') ? line : line + '\n';
    core::write_file(log, text);
    const StudyResult again = run(plan(), "out");
    EXPECT_EQ(again.earlier, 2U);
    EXPECT_EQ(again.made + again.refused, 3U);
    EXPECT_EQ(exit_code(again), 0);
    EXPECT_EQ(bytes("out"), before);
    ASSERT_EQ(again.bad_rows.count, 4U);
    for (const char* place : {"1-of-1.jsonl:1: was changed", ":2: has no checksum", ":3: has no checksum", ":6: is of no design"})
        EXPECT_TRUE(std::any_of(again.bad_rows.first.begin(), again.bad_rows.first.end(), [&](const std::string& why) {
            return why.find(place) != std::string::npos;
        })) << place;
}

TEST_F(Studies, AnIndexThatLacksDesignsNamesThemAndTheirShards) {
    (void)run(plan(), "out", {2, 3});
    const IndexSize size = write_index(plan(), folder_ / "out", false);
    EXPECT_EQ(size.designs, 2U);
    EXPECT_EQ(size.missing, 3U);
    EXPECT_EQ(size.names.size(), 3U);
    EXPECT_EQ(size.shards, 3U);
    EXPECT_EQ(size.missing_of_shard, (std::map<std::size_t, std::size_t>{{1, 2}, {3, 1}}));
}

// A list of profiles that grows at its front keeps its rows, with their new numbers.
TEST_F(Studies, AListThatGrowsKeepsItsRows) {
    const std::string text = quick_design();
    const fs::path right = write("right.toml", text), left = write("left.toml", text);
    EXPECT_EQ(run(study::Plan(study::study_of({right}, "four")), "out").made, 1U);
    const StudyResult both =
        run_study(study::Plan(study::study_of({left, right}, "four")), {.out = folder_ / "out", .jobs = 2, .shard = {}, .force = true});
    EXPECT_EQ(both.earlier, 1U);
    EXPECT_EQ(both.indexed, 2U);
    EXPECT_EQ(lines_of(core::read_file(folder_ / "out/four/index.csv"))[2].substr(0, 8), "1,right,");
}

// A link below --out leads a write elsewhere: each place is tried, and nothing is written through it.
TEST_F(Studies, NoLinkBelowOutIsFollowed) {
    const fs::path out = folder_ / "out", four = out / "four", victim = folder_ / "victim";
    fs::create_directories(victim);
    const auto refused = [&](const fs::path& link, const std::string& outputs) {
        fs::create_directories(link.parent_path());
        fs::create_directory_symlink(victim, link);
        std::size_t bad = 0;
        try {
            bad = run(plan(outputs), "out").bad_input;
        } catch (const core::IoError& e) {
            bad = std::string(e.what()).find(link.filename().string()) != std::string::npos ? 1 : 0;
        }
        EXPECT_GT(bad, 0U) << link;
        EXPECT_TRUE(fs::is_empty(victim)) << link;
        fs::remove(link);
    };
    refused(four, "figures");
    (void)run(plan(), "out");
    fs::remove_all(four / "rows");
    refused(four / "rows", "figures");
    refused(four / "designs", "meshes");
    refused(four / "designs" / plan().at(0).name, "meshes");
}

TEST_F(Studies, AFolderOfTheUsersIsNotTouched) {
    write("out/four/thesis.txt", "mine");
    EXPECT_THROW((void)run(plan(), "out"), core::IoError);
    EXPECT_EQ(core::read_file(folder_ / "out/four/thesis.txt"), "mine");
    EXPECT_FALSE(fs::exists(folder_ / "out/four/rows"));
}

TEST(Shards, AreReadAndRefused) {
    EXPECT_EQ(parse_shard("3/8").number, 3U);
    EXPECT_EQ(parse_shard("3/8").count, 8U);
    for (const char* wrong : {"", "3", "0/8", "9/8", "a/b", "1/2/3", "1/", "-1/2", "0/0", "3/2", "1/2^64", "1/18446744073709551615",
                              "1/18446744073709551616", "1/10000001", " 1/2", "1/ 2"})
        EXPECT_EQ(field_refused([&] { return parse_shard(wrong); }), "--shard") << wrong;
}

}  // namespace
}  // namespace fusee::batch
