#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "fusee/core/file.h"
#include "fusee/pipeline/check.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/study/study.h"

// A rule or a limit that breaks a shipped study fails here. tests/batch/studies.txt holds, for each study, the outcomes of its first
// designs without their meshes ('+' can be made, '-' refused) and its page, which says how many designs the whole study made.
// After a change that is meant: make the study again (its file says how), then write outcomes and page anew.
namespace fusee::study {
namespace {

namespace fs = std::filesystem;

constexpr double kMostRefused = 0.2;  // of a study that its user would call sensible

struct Record {
    std::string name, outcomes, page;
};

std::vector<Record> records() {
    std::istringstream lines(core::read_file(FUSEE_SOURCE_DIR "/tests/batch/studies.txt"));
    std::vector<Record> all;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == '#') continue;
        Record r;
        std::istringstream(line) >> r.name >> r.outcomes >> r.page;
        all.push_back(r);
    }
    return all;
}

/// "1,740": 1740
std::size_t without_commas(std::string number) {
    std::erase(number, ',');
    return std::stoul(number);
}

/// Made and planned, of the sentence "1,740 of 2,000 designs can be made" of a page.
std::pair<std::size_t, std::size_t> made_and_planned(const std::string& page) {
    const std::string text = core::read_file(fs::path(FUSEE_SOURCE_DIR) / page);
    std::smatch found;
    if (!std::regex_search(text, found, std::regex("([0-9,]+) of ([0-9,]+) designs can be made"))) return {0, 0};
    return {without_commas(found[1]), without_commas(found[2])};
}

TEST(ShippedStudies, EachHasARecord) {
    for (const auto& file : fs::directory_iterator(FUSEE_SOURCE_DIR "/profiles/studies")) {
        const auto all = records();
        const auto of_file = [&](const Record& r) { return r.name == file.path().stem(); };
        EXPECT_TRUE(std::any_of(all.begin(), all.end(), of_file)) << file.path();
    }
}

TEST(ShippedStudies, MakeMostOfTheirDesignsAsTheirPagesSay) {
    ASSERT_FALSE(records().empty());
    for (const Record& r : records()) {
        const Plan plan(read_study(fs::path(FUSEE_SOURCE_DIR) / "profiles/studies" / (r.name + ".toml")));
        ASSERT_GE(r.outcomes.size(), 32U);
        std::string found, refusals;
        for (std::size_t i = 0; i < r.outcomes.size(); ++i) {
            const core::Findings findings = pipeline::evaluate(plan.profile(plan.at(i)), pipeline::Depth::kOutline).all();
            found += core::any_error(findings) ? '-' : '+';
            if (core::any_error(findings)) refusals += fmt::format("{}: {}\n", i, core::to_line(*pipeline::binding(findings)));
        }
        EXPECT_EQ(found, r.outcomes) << r.name << "\n" << refusals;
        const auto refused = static_cast<double>(std::count(found.begin(), found.end(), '-'));
        EXPECT_LE(refused, kMostRefused * static_cast<double>(found.size())) << r.name << "\n" << refusals;
        const auto [made, planned] = made_and_planned(r.page);
        ASSERT_EQ(plan.size(), planned) << r.page;
        // Those that a mesh or a file refuses in addition are few.
        EXPECT_NEAR(static_cast<double>(made) / static_cast<double>(planned), 1.0 - refused / static_cast<double>(found.size()), 0.1);
    }
}

}  // namespace
}  // namespace fusee::study
