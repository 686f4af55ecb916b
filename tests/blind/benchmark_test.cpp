#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "fusee/blind/blind.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/plant/case_files.h"

namespace fusee::blind {
namespace {

namespace fs = std::filesystem;

class Benchmark : public testing::Test {
protected:
    void SetUp() override { fs::remove_all(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder_ = fs::temp_directory_path() / ("fusee_blind_" + std::to_string(getpid()));
};

std::map<std::string, std::string> bytes_of(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().filename() != core::kManifestName)
            files[fs::relative(entry.path(), folder).string()] = core::read_file(entry.path());
    return files;
}

TEST_F(Benchmark, SameBytesForAnyThreadCount) {
    make_benchmark({.seed = 4, .cases = 2, .out = folder_ / "one", .jobs = 1, .mix = {}, .progress = {}});
    make_benchmark({.seed = 4, .cases = 2, .out = folder_ / "two", .jobs = 2, .mix = {}, .progress = {}});
    const auto one = bytes_of(folder_ / "one");
    EXPECT_EQ(one.size(), 2U + 2U * 14U);
    EXPECT_EQ(one, bytes_of(folder_ / "two"));
}

TEST_F(Benchmark, SealIsToldBeforeAnyCaseIsWritten) {
    std::vector<std::string> told;
    const auto progress = [&](std::size_t done, std::size_t of, const std::string& what) {
        EXPECT_EQ(done, told.size());
        EXPECT_EQ(of, 1U);
        if (told.empty()) {
            EXPECT_FALSE(fs::exists(folder_ / "case000"));
        }
        told.push_back(what);
    };
    const std::string hash = make_benchmark({.seed = 5, .cases = 1, .out = folder_, .jobs = 2, .mix = {}, .progress = progress});
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0], "seal sha256:" + hash);
    EXPECT_EQ(open_seal(folder_, hash), draw_labels(5, 1));
}

TEST_F(Benchmark, WhatProgressThrowsEndsIt) {
    const auto stop = [](std::size_t done, std::size_t, const std::string&) {
        if (done == 1) throw std::runtime_error("enough");
    };
    EXPECT_THROW(make_benchmark({.seed = 5, .cases = 6, .out = folder_, .jobs = 1, .mix = {}, .progress = stop}), std::runtime_error);
    EXPECT_FALSE(fs::exists(folder_)) << "nothing is written";
}

TEST_F(Benchmark, RefusesAFolderThatHoldsSomething) {
    fs::create_directories(folder_);
    core::write_file(folder_ / "thesis.txt", "do not lose");
    EXPECT_THROW(make_benchmark({.seed = 1, .cases = 1, .out = folder_, .jobs = 1, .mix = {}, .progress = {}}), core::IoError);
    EXPECT_THROW(make_benchmark({.seed = 1, .cases = 1, .out = {}, .jobs = 1, .mix = {}, .progress = {}}), core::InvalidInput);
    EXPECT_EQ(core::read_file(folder_ / "thesis.txt"), "do not lose");
    const BenchmarkOptions first{.seed = 1, .cases = 1, .out = folder_ / "new", .jobs = 1, .mix = {}, .progress = {}};
    BenchmarkOptions second = first;
    second.seed = 2;
    make_benchmark(first);
    make_benchmark(first);
    EXPECT_THROW(make_benchmark(second), core::IoError) << "of another seed";
    second.force = true;
    make_benchmark(second);
}

TEST(DrawLabels, SharesAreThoseOfTheMixAndIdsComeEvenly) {
    const std::vector<Label> labels = draw_labels(6, 200);
    std::size_t none = 0, two = 0, outside = 0;
    std::map<std::string, int> alone, beyond;
    for (const Label& label : labels) {
        none += label.effects.empty();
        two += label.effects.size() == 2;
        outside += !label.in_library;
        if (label.effects.size() == 1) ++(label.in_library ? alone : beyond)[label.effects[0].id];
        if (label.effects.size() == 2) {
            EXPECT_NE(label.effects[0].id, label.effects[1].id);
        }
    }
    EXPECT_EQ(none, 30U);
    EXPECT_EQ(two, 30U);
    EXPECT_EQ(outside, 30U);
    EXPECT_EQ(alone.size(), plant::library_ids().size());
    EXPECT_EQ(beyond.size(), plant::outside_ids().size());
    for (const auto& [id, times] : beyond) EXPECT_TRUE(times == 1 || times == 2) << id;
    EXPECT_NE(labels, draw_labels(7, 200));
}

TEST(DrawLabels, AFormBlindFamilyHasEachOfItsEffects) {
    std::map<std::string, int> ids;
    for (const Label& label : draw_labels(6, 40, kOutsideOnly, Family::kFormBlind)) {
        ASSERT_EQ(label.effects.size(), 1u);
        EXPECT_FALSE(label.in_library);
        ++ids[label.effects[0].id];
    }
    ASSERT_EQ(ids.size(), plant::form_blind_ids().size());
    for (const auto& [id, times] : ids) EXPECT_EQ(times, 5) << id;
}

TEST(DrawLabels, MujocosFamilyHasTheUsualEffectsAndItsOwn) {
    std::set<std::string> ids;
    for (const Label& label : draw_labels(6, 17, kOutsideOnly, Family::kEngine)) ids.insert(label.effects.at(0).id);
    EXPECT_EQ(ids.size(), plant::outside_ids().size() + 1);
    EXPECT_TRUE(ids.contains("outside.joint_play"));
}

TEST(DrawLabels, ADoubtfulFamilyHasEachDoubtAndIsSealedWithIt) {
    const std::vector<Label> labels = draw_labels(6, 2 * doubts().size(), {}, Family::kDoubtful);
    std::map<std::string, int> times;
    for (const Label& label : labels) {
        ++times[label.doubt];
        const std::size_t expected = label.doubt == "three effects"   ? 3
                                     : label.doubt == "four effects"  ? 4
                                     : label.doubt == "unequal sides" ? 2
                                     : label.doubt == "noise alone"   ? 0
                                                                      : 1;
        EXPECT_EQ(label.effects.size(), expected) << label.doubt;
        EXPECT_EQ(label.conditions.noise > 1.0, label.doubt.starts_with("noise"));
        EXPECT_EQ(label.conditions.linear_springs, label.doubt == "linear springs");
        EXPECT_EQ(label.conditions.experiments.size(), label.doubt == "two experiments" ? 2U : 0U);
        if (label.doubt == "unequal sides") {
            EXPECT_EQ(label.effects[0].id, label.effects[1].id);
            EXPECT_NE(label.effects[0].size, label.effects[1].size);
        }
    }
    EXPECT_EQ(times.size(), doubts().size());
    for (const auto& [doubt, count] : times) EXPECT_EQ(count, 2) << doubt;
    const fs::path folder = fs::temp_directory_path() / ("fusee_doubtful_" + std::to_string(getpid()));
    fs::create_directories(folder);
    const std::string sealed = seal_labels(labels, 6);
    core::write_file(folder / "labels.sealed", sealed);
    core::write_file(folder / "seal.txt", "sha256:" + core::sha256_hex(sealed) + "\n");
    EXPECT_EQ(open_seal(folder, core::sha256_hex(sealed)), labels);
    fs::remove_all(folder);
}

TEST_F(Benchmark, OnlyThePlantHasDoubtfulCases) {
    BenchmarkOptions options{.seed = 1, .cases = 1, .out = folder_, .jobs = 1, .mix = {}, .maker = Maker::kModel, .progress = {}};
    options.family = Family::kDoubtful;
    EXPECT_THROW(make_benchmark(options), core::InvalidInput);
}

TEST(DrawLabels, RefusesAMixThatIsNone) {
    EXPECT_THROW(static_cast<void>(draw_labels(1, 0)), core::InvalidInput);
    EXPECT_THROW(static_cast<void>(draw_labels(1, 5, {0.6, 0.5, 0.0})), core::InvalidInput);
    EXPECT_THROW(static_cast<void>(draw_labels(1, 5, {-0.1, 0.5, 0.0})), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::blind
