#include "fusee/batch/batch.h"

#include <algorithm>
#include <cmath>
#include <csignal>

#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "fusee/core/units.h"
#include "fusee/profile/places.h"
#include "pipeline/fixture.h"

namespace fusee::batch {
namespace {

namespace fs = std::filesystem;

class Batch : public fixtures::TempFolder {
protected:
    /// The shipped design under another name, with changes; fewer files, since these tests are about rows.
    fs::path design(const std::string& name, const fixtures::Changes& changes = {}) const {
        std::string text = core::read_file(fixtures::shipped("pnrvsa"));
        text = fixtures::with_keys(text, {{"name", "\"" + name + "\""}, {"outputs.formats", "[\"stl\"]"}, {"outputs.springs_rows", "200"}});
        return write("profiles/" + name + ".toml", fixtures::with_keys(text, changes));
    }
    std::vector<Row> make(const std::vector<fs::path>& profiles, unsigned jobs, const std::string& out = "out") const {
        return make_all(profiles, {.out = folder_ / out}, jobs);
    }
};

std::vector<Outcome> outcomes(const std::vector<Row>& rows) {
    std::vector<Outcome> all;
    for (const Row& row : rows) all.push_back(row.outcome);
    return all;
}

TEST_F(Batch, FolderStandsForItsProfilesByName) {
    const fs::path b = write("p/b.toml", ""), a = write("p/a.toml", ""), other = write("other.toml", "");
    write("p/notes.txt", "");
    write("p/deeper/c.toml", "");
    fs::create_directories(folder_ / "p" / "d.toml");
    EXPECT_EQ(profile::find_profiles({other, folder_ / "p"}), (std::vector<fs::path>{other, a, b}));
    EXPECT_EQ(profile::find_profiles({folder_ / "missing.toml"}), (std::vector<fs::path>{folder_ / "missing.toml"}))
        << "its row says that it is missing";
    EXPECT_THROW((void)profile::find_profiles({folder_ / "p" / "deeper" / ".." / "d.toml"}), core::IoError) << "a folder without profiles";
    EXPECT_EQ(profile::find_profiles({std::string(5000, 'a')}).size(), 1u) << "no name that a file system takes";
}

TEST_F(Batch, OneFailureIsOneRowAndTheRestGoesOn) {
    const std::vector<fs::path> profiles{design("first"), write("broken.toml", "name = [\n"),
                                         design("refused", {{"k_pe.spring.preload_mm", "0.0"}}), folder_ / "missing.toml", design("last")};
    const std::vector<Row> rows = make(profiles, 2);
    EXPECT_EQ(outcomes(rows), (std::vector{Outcome::kMade, Outcome::kBadInput, Outcome::kRefused, Outcome::kBadInput, Outcome::kMade}));
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].profile, profiles[i]);
    EXPECT_EQ(exit_code(rows), 2);
    std::vector<std::string> made;
    for (const auto& entry : fs::directory_iterator(folder_ / "out")) made.push_back(entry.path().filename().string());
    std::sort(made.begin(), made.end());
    EXPECT_EQ(made, (std::vector<std::string>{"first", "last"}));
    const std::string table = closing_table(rows);
    for (const char* words : {"first.toml", "broken.toml:", "cam.arm", "missing.toml", "refused", "last.toml"})
        EXPECT_NE(table.find(words), std::string::npos) << words << " in\n" << table;
}

TEST_F(Batch, TheSameRowsAndBytesForAnyNumberOfJobs) {
    const std::vector<fs::path> profiles{
        design("a"),
        design("b", {{"k_se.torque_sign", "-1"}, {"k_se.spring.hand", "\"right\""}, {"k_se.features.leg_slot_angle_deg", "90"}}),
        write("bad.toml", "x = 1\n"), design("c", {{"cable.diameter_mm", "0.6"}, {"cable.breaking_load_N", "600"}}), design("d")};
    const std::vector<Row> one = make(profiles, 1, "one"), four = make(profiles, 4, "four");
    ASSERT_EQ(outcomes(one), outcomes(four));
    EXPECT_EQ(std::count(profiles.begin(), profiles.end(), one[2].profile), 1);
    EXPECT_TRUE(fixtures::contents(folder_ / "one") == fixtures::contents(folder_ / "four"));
    EXPECT_EQ(fixtures::contents(folder_ / "one").size(),
              4u * 35u);  // per design: springs, two reports, three of the simulation, seven of the joint, its nine bodies and the five
                          // of its frame beside the cams; STL and PART.json of four parts
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].error, four[i].error);
}

TEST_F(Batch, TwoProfilesOfOneNameDoNotShareAFolder) {
    const fs::path first = design("twin"), second = folder_ / "copy.toml";
    fs::copy_file(first, second);
    const std::vector<Row> rows = make({first, second}, 2);
    EXPECT_EQ(outcomes(rows), (std::vector{Outcome::kMade, Outcome::kBadInput}));
    EXPECT_NE(rows[1].error.find("copy.toml:"), std::string::npos) << rows[1].error;
    EXPECT_NE(rows[1].error.find("name"), std::string::npos);
}

// A mistake that only a module below finds still comes with file, line and key.
TEST_F(Batch, BadInputFoundLateNamesItsLine) {
    const std::vector<Row> rows = make({design("wide", {{"k_se.hub.key_width_mm", "9.0"}}), design("slick", {{"rig.gear_friction", "0.0"}}),
                                        design("unpitched", {{"k_pe.path.kind", "\"helix\""}})},
                                       1);
    const auto line_of = [](const Row& row, const std::string& key) {
        const std::string text = core::read_file(row.profile);
        return row.profile.string() + ":" +
               std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(key)), '\n'));
    };
    EXPECT_EQ(outcomes(rows), (std::vector{Outcome::kBadInput, Outcome::kBadInput, Outcome::kBadInput}));
    EXPECT_EQ(rows[0].error.rfind(line_of(rows[0], "key_width_mm") + ":", 0), 0u) << rows[0].error;
    EXPECT_NE(rows[0].error.find("k_se.hub.key_width_mm: 9"), std::string::npos) << rows[0].error;
    EXPECT_EQ(rows[1].error.rfind(line_of(rows[1], "gear_friction") + ":", 0), 0u) << rows[1].error;
    EXPECT_EQ(rows[2].error.rfind(line_of(rows[2], "[k_pe.path]") + ":", 0), 0u) << "left out: its table is named: " << rows[2].error;
    EXPECT_NE(rows[2].error.find("k_pe.path.pitch_mm: missing"), std::string::npos) << rows[2].error;
}

TEST(ExitCode, TheGravestCounts) {
    const auto code = [](std::vector<Outcome> all) {
        std::vector<Row> rows(all.size());
        for (std::size_t i = 0; i < all.size(); ++i) rows[i].outcome = all[i];
        return exit_code(rows);
    };
    EXPECT_EQ(code({}), 0);
    EXPECT_EQ(code({Outcome::kMade, Outcome::kMade}), 0);
    EXPECT_EQ(code({Outcome::kRefused, Outcome::kMade}), 1);
    EXPECT_EQ(code({Outcome::kRefused, Outcome::kBadInput, Outcome::kMade}), 2);
    EXPECT_EQ(code({Outcome::kFailed, Outcome::kBadInput}), 3);
    EXPECT_EQ(code({Outcome::kMade, Outcome::kInterrupted, Outcome::kFailed}), 130);
}

TEST(ClosingTable, LeadsWithWhatTheUserGetsAndSaysWhatWasNotJudged) {
    Row row;
    row.outcome = Outcome::kMade;
    row.profile = "a.toml";
    row.result.headline.process = "fdm";
    row.result.headline.least = {0.85, core::rad_from_deg(75.5)};
    row.result.headline.overdrive = {1.5, core::rad_from_deg(20.4)};
    row.result.findings = {core::not_judged("spring.stress", "the wire yielding", "k_se.spring.wire_mm")};
    const std::string table = closing_table({row});
    EXPECT_NE(table.find("0 rules passed, 0 warnings; 1 rule not judged: spring 1 (`fusee check a.toml` lists what is missing)"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("\n    75.5 to 20.4 deg  "), std::string::npos) << table;
    EXPECT_EQ(table.find("rule passed, 0 warnings; 0"), std::string::npos);
}

// In a process of its own: the request to stop cannot be taken back.
TEST_F(Batch, AfterARequestToStopNothingIsBegun) {
    const fs::path good = design("never"), bad = write("bad.toml", "");
    const auto stopped = [&] {
        core::catch_interrupts();
        std::raise(SIGINT);
        const std::vector<Row> rows = make_all({good, bad}, {.out = folder_ / "out"}, 2);
        const bool right =
            rows[0].outcome == Outcome::kInterrupted && rows[1].outcome == Outcome::kBadInput && !fs::exists(folder_ / "out");
        std::_Exit(right ? exit_code(rows) : 99);
    };
    EXPECT_EXIT(stopped(), testing::ExitedWithCode(130), "");
}

TEST(Interrupts, ASecondRequestEndsAtOnce) {
    const auto twice = [] {
        core::catch_interrupts();
        std::raise(SIGINT);
        std::raise(SIGINT);
    };
    EXPECT_EXIT(twice(), testing::KilledBySignal(SIGINT), "");
}

}  // namespace
}  // namespace fusee::batch
