#include <nlohmann/json.hpp>

#include "fusee/core/error.h"
#include "fusee/paper/paper.h"
#include "fusee/report/paper.h"
#include "pipeline/fixture.h"
#include "report/page_structure.h"
#include "shipped.h"

namespace fusee::paper {
namespace {

using namespace fixtures;

class PaperRun : public TempFolder {
protected:
    [[nodiscard]] static PaperOptions options(unsigned jobs = 2) {
        PaperOptions options;
        options.profiles = fs::path(FUSEE_SOURCE_DIR) / "profiles";
        options.jobs = jobs;
        return options;
    }
    /// The files of a paper, by name.
    [[nodiscard]] std::map<std::string, std::string> written(const Result& result, const std::string& out) const {
        fs::create_directories(folder_ / out);
        report::write_paper(result.paper.value(), folder_ / out);
        return contents(folder_ / out);
    }
    /// The shipped profiles in the test's folder, to be changed.
    [[nodiscard]] fs::path copied() const {
        fixtures::copy_shipped("profiles", folder_);
        return folder_ / "profiles";
    }
};

TEST_F(PaperRun, ReproducesEveryTableAndFigureWithEqualBytesOnAnyNumberOfThreads) {
    PaperOptions watched = options(1);
    std::vector<std::string> pieces;
    watched.note = [&](const std::string& piece) { pieces.push_back(piece); };
    const Result made = run(watched);
    ASSERT_TRUE(made.paper);
    EXPECT_EQ(pieces.size(), kPieces);
    EXPECT_NE(report::paper_text(*made.paper).find("table II"), std::string::npos);

    const auto files = written(made, "one");
    for (const char* name : {"figure_1.csv", "figure_2.csv", "figure_2_passive.csv", "figure_8.csv", "figure_9.csv", "figure_9_springs.csv",
                             "figure_9_arms.csv", "table_1.csv", "table_2.csv", "relatives.csv", "paper.json", "paper.html"})
        EXPECT_TRUE(files.contains(name)) << name;
    const auto json = nlohmann::json::parse(files.at("paper.json"));
    EXPECT_EQ(json["claims"].size(), 8u);
    EXPECT_EQ(json["table_1"]["rows"].size(), 4u);
    EXPECT_EQ(json["table_2"]["rows"].size(), 5u);
    EXPECT_EQ(json["relatives"].size(), 6u);
    EXPECT_NEAR(json["figure_8"]["mu"].get<double>(), 0.28, 0.005);
    EXPECT_LT(json["figure_9"]["cost"].get<double>(), 0.0);
    EXPECT_EQ(report::data_of(files.at("paper.html")), json);

    EXPECT_EQ(written(run(options(3)), "three"), files);
}

TEST_F(PaperRun, StoppedInBetweenGivesNoPaper) {
    PaperOptions stopped = options();
    int asked = 0;
    stopped.stop = [&] { return ++asked > 2; };
    const Result result = run(stopped);
    EXPECT_TRUE(result.interrupted);
    EXPECT_FALSE(result.paper);
}

TEST_F(PaperRun, ALawThatCannotExistIsNamedWithItsProfile) {
    PaperOptions changed = options();
    changed.profiles = copied();
    const fs::path springs = changed.profiles / "paper" / "new_springs.toml";
    core::write_file(springs, with_key(core::read_file(springs), "law.start_torque_Nm", "0.01"));
    const Result result = run(changed);
    EXPECT_FALSE(result.paper);
    ASSERT_FALSE(result.findings.empty());
    EXPECT_EQ(result.findings.front().rule, "law.transmission");
    EXPECT_EQ(result.findings.front().where.rfind("new_springs", 0), 0u) << result.findings.front().where;
}

TEST_F(PaperRun, MissingSourcesAreNamed) {
    PaperOptions missing = options();
    missing.profiles = copied();
    fs::remove(missing.profiles / "examples" / "break_away.csv");
    EXPECT_THROW((void)run(missing), core::IoError);
    missing.profiles = folder_ / "nowhere";
    EXPECT_THROW((void)run(missing), core::IoError);
}

}  // namespace
}  // namespace fusee::paper
