#include "app/run.h"

namespace fusee::app {
namespace {

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

TEST_F(Program, DesignFindsSpringsAndWritesThem) {
    const Ended found = run("design " + quoted(fixtures::shipped("pnrvsa")) + " --out found --generations 100 --seed 3");
    EXPECT_EQ(found.code, 0) << found.all();
    expect_words(found.out, {"k = ", "linear dead-band from", "found/pnrvsa-design/", "k_pe can be cut"});
    expect_words(found.err, {"design 25/25: generation 100"});
    for (const char* file : {"design.json", "design.html", "history.csv", "figure_9.csv", "pnrvsa-best.toml"})
        EXPECT_TRUE(fs::exists(folder_ / "found" / "pnrvsa-design" / file)) << file;
    EXPECT_TRUE(fs::exists(folder_ / "found" / "pnrvsa-design.checkpoint"));

    const Ended other = run("design " + quoted(fixtures::shipped("pnrvsa")) + " --out found --generations 100 --seed 4 --resume");
    EXPECT_EQ(other.code, 2);
    expect_words(other.err, {"pnrvsa-design.checkpoint: seed: 3 (allowed: 4"});
}

TEST_F(Program, DesignWithoutSpringsEndsWith1) {
    write("t.toml", fixtures::with_key(core::read_file(fixtures::shipped("pnrvsa")), "algorithm_1.u_Nm", "[0.5, 0.6]"));
    const Ended none = run("design t.toml --generations 20");
    EXPECT_EQ(none.code, 1);
    EXPECT_EQ(none.out, "");
    expect_words(none.err, {"error: design.feasible", "algorithm_1.u_Nm = [0, "});
    EXPECT_FALSE(fs::exists(folder_ / "out" / "pnrvsa-design"));
}

TEST_F(Program, DesignNamesWrongInput) {
    const std::string shipped = core::read_file(fixtures::shipped("pnrvsa"));
    write("box.toml", fixtures::with_key(shipped, "algorithm_1.c_Nm", "[0.4, 0.1]"));
    write("low.toml", fixtures::with_key(shipped, "algorithm_1.k_per_Nm_rad", "[0.0, 0.1]"));
    write("method.toml", fixtures::with_key(shipped, "design.method", "\"luck\""));
    const std::pair<std::string, std::string> cases[] = {{"design", "profile"},
                                                         {"design missing.toml", "missing.toml"},
                                                         {"design box.toml --method luck", "luck"},
                                                         {"design box.toml --population 7", "--population"},
                                                         {"design box.toml --generations 0", "--generations"},
                                                         {"design box.toml --seed -1", "--seed"},
                                                         {"design box.toml --jobs x", "--jobs"},
                                                         {"design box.toml", "algorithm_1.c_Nm: [0.4, 0.1]"},
                                                         {"design low.toml", "algorithm_1.k_per_Nm_rad"},
                                                         {"design method.toml", "design.method"}};
    for (const auto& [arguments, word] : cases) {
        const Ended wrong = run(arguments);
        EXPECT_EQ(wrong.code, 2) << arguments << wrong.all();
        EXPECT_EQ(wrong.out, "") << arguments;
        expect_words(wrong.err, {word});
    }
    expect_words(run("design box.toml").err, {"box.toml:"});
}

}  // namespace
}  // namespace fusee::app
