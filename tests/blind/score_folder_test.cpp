#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/blind/score.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "fusee/gap_case/case.h"

// A benchmark on disk, from seal to score; diagnoses are written by hand: a real one takes seconds.
namespace fusee::blind {
namespace {

namespace fs = std::filesystem;

class ScoreFolder : public testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(folder_);
        BenchmarkOptions options;
        options.seed = 3;
        options.cases = 2;
        options.out = folder_;
        options.jobs = 1;
        options.mix = {0.0, 0.0, 0.0};
        options.maker = Maker::kModel;
        hash_ = make_benchmark(options);
        labels_ = open_seal(folder_, hash_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] ScoreOptions options() const {
        ScoreOptions options;
        options.folder = folder_;
        options.hash = hash_;
        options.jobs = 1;
        return options;
    }
    [[nodiscard]] fs::path diagnosis_file(const Label& label) const { return folder_ / "diagnoses" / label.case_name / "diagnosis.json"; }
    /// A diagnosis that is right.
    void diagnose(const Label& label) const {
        nlohmann::json j{{"verdict", "identified"},
                         {"effects", nlohmann::json::array()},
                         {"alternatives", nlohmann::json::array()},
                         {"gap", {{"heldout_before", 8.0}, {"heldout_after", 2.0}}},
                         {"case_sha256", gap_case::read_case(folder_ / label.case_name).sha256}};
        for (const LabelEffect& e : label.effects) {
            nlohmann::json effect{{"id", e.id},
                                  {"side", e.side},
                                  {"probability", 0.9},
                                  {"parameter", {{"value", e.size}, {"ci95", {e.size - 1e-3, e.size + 1e-3}}}}};
            for (const auto& extra : e.extra) effect["extra"]["v_s"] = extra.second;
            j["effects"].push_back(effect);
        }
        fs::create_directories(diagnosis_file(label).parent_path());
        core::write_file(diagnosis_file(label), j.dump());
    }
    [[nodiscard]] fs::path held_out_file(std::size_t i) const { return folder_ / "diagnoses" / labels_[i].case_name / "held_out.json"; }

    fs::path folder_ = fs::temp_directory_path() / ("fusee_score_" + std::to_string(getpid()));
    std::string hash_;
    std::vector<Label> labels_;
};

TEST_F(ScoreFolder, ReadsDiagnosesAgainAndMeasuresTheGapKeptBack) {
    for (const Label& label : labels_) diagnose(label);
    ScoreOptions stopped = options();
    std::size_t finished = 0;
    stopped.progress = [&](std::size_t done, std::size_t, const std::string&) { finished = done; };
    stopped.stop = [&] { return finished == 1; };
    EXPECT_THROW(static_cast<void>(score(stopped)), core::Stopped);
    EXPECT_FALSE(fs::exists(held_out_file(1)));
    const std::string before = core::read_file(held_out_file(0));

    const Score first = score(options());
    EXPECT_EQ(core::read_file(held_out_file(0)), before) << "what was finished stays";
    EXPECT_EQ(first.seal, hash_);
    EXPECT_EQ(first.cases, 2u);
    EXPECT_EQ(first.figure("effect_and_side").share.hits, 2u);
    EXPECT_TRUE(std::isnan(first.median_seconds)) << "nothing was diagnosed";
    for (const std::size_t i : {0u, 1u}) {
        // Only build tolerances and noise are left, which sigma holds: 1.0 to 1.4 on four faultless rigs, and 0.6 to 2.5 on six with an
        // effect, where tolerances weigh otherwise than on the nominal rig.
        const auto kept = nlohmann::json::parse(core::read_file(held_out_file(i)));
        EXPECT_GT(kept["after"], 0.4);
        EXPECT_LT(kept["after"], 3.0);
        EXPECT_GT(kept["before"], kept["after"]);
        EXPECT_DOUBLE_EQ(first.shrink.at(i).claimed, 0.25);
        EXPECT_DOUBLE_EQ(first.shrink.at(i).measured, kept["after"].get<double>() / kept["before"].get<double>());
        EXPECT_DOUBLE_EQ(first.shrink.at(i).as_claimed, kept["as_claimed_after"].get<double>() / kept["as_claimed_before"].get<double>());
        EXPECT_LT(kept["as_claimed_after"], 3.0);
        EXPECT_GT(kept["as_claimed_before"], kept["as_claimed_after"]);
    }
    ScoreOptions two = options();
    two.jobs = 2;
    EXPECT_EQ(score_json(score(two)), score_json(first));

    // The file of the version before is read under its name.
    fs::rename(held_out_file(1), held_out_file(1).parent_path() / "kept_back.json");
    EXPECT_EQ(score_json(score(options())), score_json(first));
    EXPECT_FALSE(fs::exists(held_out_file(1)));

    // A diagnosis that changed is measured anew.
    Label wrong = labels_[0];
    wrong.effects[0] = {"joint.coulomb", "none", 0.01, {}};
    diagnose(wrong);
    ScoreOptions one = options();
    one.limit = 1;
    const Score other = score(one);
    EXPECT_EQ(other.cases, 1u);
    EXPECT_EQ(other.figure("effect_named").share.hits, 0u);
    EXPECT_GT(other.shrink.at(0).measured, first.shrink.at(0).measured);
}

// One diagnosis with an arm that no spool has took all of the score with it.
TEST_F(ScoreFolder, ADiagnosisThatNoRigCanBeIsAMissOfItsCase) {
    for (const Label& label : labels_) diagnose(label);
    Label wrong = labels_[0];
    for (const auto& [id, size] : {std::pair{"se.radius", -0.02}, {"gear.coulomb", -1e308}}) {
        wrong.effects = {{id, "both", size, {}}};
        diagnose(wrong);
        const Score found = score(options());
        EXPECT_EQ(found.figure("effect_and_side").share.hits, 1u);
        ASSERT_EQ(found.misses.size(), 1u);
        EXPECT_NE(found.misses[0].what.find(std::string("effects[0]: ") + id), std::string::npos) << found.misses[0].what;
    }
    core::write_file(diagnosis_file(labels_[0]), std::string(100'000, '['));
    ScoreOptions again = options();
    again.stop = [] { return true; };
    EXPECT_THROW(static_cast<void>(score(again)), core::Stopped) << "what is no diagnosis is made anew";
}

TEST_F(ScoreFolder, TheModelsCasesAreTheSameForAnyThreadCount) {
    BenchmarkOptions options;
    options.seed = 3;
    options.cases = 2;
    options.out = folder_ / "again";
    options.jobs = 2;
    options.mix = {0.0, 0.0, 0.0};
    options.maker = Maker::kModel;
    EXPECT_EQ(make_benchmark(options), hash_);
    for (const char* file : {"case000/log.csv", "case001/heldout/dead_band.csv", "case001/case.toml"})
        EXPECT_EQ(core::read_file(folder_ / file), core::read_file(folder_ / "again" / file)) << file;
}

/// Cases that cannot be read: each is a miss at once.
class SealedFolder : public testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(options_.folder);
        for (const Label& label : labels_) {
            fs::create_directories(options_.folder / label.case_name);
            core::write_file(options_.folder / label.case_name / "case.toml", "no rig\n");
        }
        const std::string sealed = seal_labels(labels_, 1);
        options_.hash = core::sha256_hex(sealed);
        core::write_file(options_.folder / "labels.sealed", sealed);
        core::write_file(options_.folder / "seal.txt", options_.hash + "\n");
    }
    void TearDown() override { fs::remove_all(options_.folder); }
    void tamper() const { core::write_file(options_.folder / "labels.sealed", seal_labels({labels_[0]}, 1)); }
    void expect_seal_refused() const {
        try {
            static_cast<void>(score(options_));
            FAIL() << "scored";
        } catch (const core::InvalidInput& refused) {
            EXPECT_EQ(refused.field(), "seal");
        }
    }

    std::vector<Label> labels_{{"case000", {}, true}, {"case001", {{"joint.stop", "none", 0.3, {}}}, true}};
    std::size_t told_ = 0;
    ScoreOptions options_{.folder = fs::temp_directory_path() / ("fusee_sealed_" + std::to_string(getpid())),
                          .hash = {},
                          .jobs = 1,
                          .limit = 0,
                          .again = false,
                          .progress = [this](std::size_t, std::size_t, const std::string&) { ++told_; },
                          .stop = {}};
};

TEST_F(SealedFolder, ACaseThatCannotBeReadIsAMiss) {
    const Score found = score(options_);
    EXPECT_EQ(told_, 2u);
    ASSERT_EQ(found.misses.size(), 2u);
    EXPECT_NE(found.misses[0].what.find("case.toml"), std::string::npos) << found.misses[0].what;
    options_.hash.clear();
    EXPECT_EQ(score_json(score(options_)), score_json(found)) << "seal.txt has the hash too";
}

TEST_F(SealedFolder, ABrokenSealIsRefusedBeforeAnyCaseIsTouched) {
    tamper();
    expect_seal_refused();
    EXPECT_EQ(told_, 0u);
}

TEST_F(SealedFolder, LabelsThatWereChangedMeanwhileAreRefused) {
    options_.progress = [this](std::size_t, std::size_t of, const std::string& what) {
        EXPECT_EQ(of, 2u);
        EXPECT_EQ(what, labels_[told_++].case_name + ": failed");
        tamper();
    };
    expect_seal_refused();
    EXPECT_EQ(told_, 2u);
}

TEST_F(SealedFolder, StopsWhenAsked) {
    options_.stop = [this] { return told_ == 1; };
    EXPECT_THROW(static_cast<void>(score(options_)), core::Stopped);
    EXPECT_EQ(told_, 1u);
}

TEST_F(SealedFolder, AMissingCaseIsRefused) {
    fs::remove_all(options_.folder / "case001");
    EXPECT_THROW(static_cast<void>(score(options_)), core::InvalidInput);
    fs::remove_all(options_.folder / "case000");
    EXPECT_THROW(static_cast<void>(score(options_)), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::blind
