#include <nlohmann/json.hpp>

#include "app/run.h"
#include "fusee/core/file.h"
#include "fusee/gap_case/case.h"

// The sealed benchmark from the command line: `blind make`, `blind score`.
namespace fusee::app {
namespace {

class Blind : public Program {
protected:
    /// An answer by hand, so that no diagnosis has to be made: they take seconds.
    void answer_none(const std::string& name, const std::string& sha256) const {
        write("bench/diagnoses/" + name + "/diagnosis.json", R"({"verdict": "none", "effects": [], "case_sha256": ")" + sha256 + R"("})");
    }
    [[nodiscard]] std::string sha256_of(const std::string& name) const { return gap_case::read_case(folder_ / "bench" / name).sha256; }
};

TEST_F(Blind, MakesASealedBenchmarkAndScoresIt) {
    const Ended made = run("blind make --seed 8 --cases 2 --out bench --plant model --jobs 1");
    ASSERT_EQ(made.code, 0) << made.all();
    std::string seal = core::read_file(folder_ / "bench" / "seal.txt");
    ASSERT_TRUE(seal.ends_with("\n"));
    seal.pop_back();
    EXPECT_TRUE(made.out.starts_with("seal " + seal + "\n")) << made.out;
    EXPECT_TRUE(fs::exists(folder_ / "bench" / "case001" / "heldout" / "log.csv"));

    for (const char* name : {"case000", "case001"}) answer_none(name, sha256_of(name));
    const Ended scored = run("blind score bench --seal " + seal + " --model bench --jobs 1 --out 'my score'");
    ASSERT_EQ(scored.code, 0) << scored.all();
    expect_words(scored.out,
                 {"2 cases, seal " + seal, "effect named", "at least 95 %", "shuffled", "model", "written: my score/score.html"});
    const auto json = nlohmann::json::parse(core::read_file(folder_ / "my score" / "score.json"));
    EXPECT_EQ(json["cases"], 2);
    EXPECT_EQ(json["seal"], seal);
    EXPECT_EQ(json["model"]["cases"], 2);
    const std::string page = core::read_file(folder_ / "my score" / "score.html");
    expect_words(page, {"data-page=\"score\"", "\"confusion\":", "\"misses\":", seal});
}

TEST_F(Blind, RefusesBadInput) {
    const auto expect_refused = [&](const std::string& arguments, std::initializer_list<std::string> words) {
        const Ended refused = run(arguments);
        EXPECT_EQ(refused.code, 2) << refused.all();
        expect_words(refused.err, words);
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    };
    expect_refused("blind", {"subcommand"});
    expect_refused("blind make --seed 1 --out out", {"--cases"});
    expect_refused("blind make --seed 1 --cases 0 --out out", {"cases", "0"});
    expect_refused("blind make --seed 1 --cases 1 --out out --plant garden", {"--plant", "garden"});
    expect_refused("blind make --seed 1 --cases 1 --out out --family odd", {"--family", "odd", "form-blind"});
    expect_refused("blind make --seed 1 --cases 1 --out out --plant model --family form-blind", {"family", "the model has none"});
    write("full/thesis.txt", "do not lose");
    expect_refused("blind make --seed 1 --cases 1 --out full", {"full: fusee did not make this folder", "thesis.txt"});
    expect_refused("blind score full --out out", {"full/seal.txt"});
    expect_refused("blind score full --seal 0123 --out out", {"labels.sealed"});
    write("full/labels.sealed", "QUJD\n");
    expect_refused("blind score full --seal 0123 --out out", {"seal", "0123"});
}

}  // namespace
}  // namespace fusee::app
