#include "fusee/batch/batch.h"
#include "pipeline/fixture.h"

namespace fusee::batch {
namespace {

namespace fs = std::filesystem;

class SimulateAll : public fixtures::TempFolder {
protected:
    std::vector<fs::path> profiles() const {
        const fs::path relatives = fs::path(FUSEE_SOURCE_DIR) / "profiles" / "relatives";
        const std::string text = core::read_file(relatives / "pnrvsa.toml");
        return {relatives / "pnrvsa.toml", write("bad.toml", "name = [\n"), relatives / "cross_coupled.toml",
                write("refused.toml", fixtures::with_keys(text, {{"name", "\"refused\""}, {"law.parallel_Nm", "[0.0, 0.25, -0.09]"}})),
                relatives / "series_elastic.toml"};
    }
    std::vector<SimulationRow> simulated(const std::string& out, unsigned jobs) const {
        return simulate_all(profiles(), folder_ / out, {.levels = 3}, jobs);
    }
};

TEST_F(SimulateAll, OneFailureIsOneRowAndTheRestIsCompared) {
    const auto rows = simulated("out", 2);
    ASSERT_EQ(rows.size(), 5u);
    const std::vector<Outcome> expected{Outcome::kMade, Outcome::kBadInput, Outcome::kMade, Outcome::kRefused, Outcome::kMade};
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].outcome, expected[i]) << i << rows[i].error;
    EXPECT_EQ(exit_code(rows), 2);
    EXPECT_EQ(rows[3].refusal.front().rule, "law.stiffness");
    EXPECT_FALSE(fs::exists(folder_ / "out" / "refused"));
    const std::string table = closing_table(rows);
    for (const char* words : {"bad.toml:", "law.stiffness", "cross_coupled", "held [Nm/rad]"})
        EXPECT_NE(table.find(words), std::string::npos) << words << " in\n" << table;
}

TEST_F(SimulateAll, TheSameBytesForAnyNumberOfJobs) {
    (void)simulated("one", 1);
    (void)simulated("four", 4);
    const auto one = fixtures::contents(folder_ / "one");
    EXPECT_EQ(one.size(), 3u * 3u + 1u) << "three files each, and the comparison";
    EXPECT_TRUE(one == fixtures::contents(folder_ / "four"));
}

}  // namespace
}  // namespace fusee::batch
