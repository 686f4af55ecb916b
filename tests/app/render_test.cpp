#include "app/run.h"

namespace fusee::app {
namespace {

class Render : public Program {
protected:
    void SetUp() override {
        Program::SetUp();
        write("pnrvsa.toml", core::read_file(fixtures::shipped("pnrvsa")));
    }
};

// The README shows what the command draws. If this fails on purpose: cmake --build build --target docs_pictures
TEST_F(Render, DrawsTheReadmesPicture) {
    const Ended ended = run("render pnrvsa.toml --view cams -o cams.png");
    ASSERT_EQ(ended.code, 0) << ended.all();
    EXPECT_TRUE(core::read_file(folder_ / "cams.png") == core::read_file(fs::path(FUSEE_SOURCE_DIR) / "docs/images/cams.png"));
}

TEST_F(Render, PosesTheJointAndStatesItsRange) {
    const std::string begin = "render pnrvsa.toml --co-contraction 1.2 ";
    ASSERT_EQ(run(begin + "-o low.svg --width 300").code, 0);
    ASSERT_EQ(run(begin + "-o turned.svg --width 300 --joint-angle 10").code, 0);
    EXPECT_NE(core::read_file(folder_ / "low.svg"), core::read_file(folder_ / "turned.svg"));
    const Ended beyond = run(begin + "-o far.svg --joint-angle 90");
    EXPECT_EQ(beyond.code, 2);
    expect_words(beyond.err, {"--joint-angle", "90", "allowed: -16.5 to 16.5 deg"});
    const Ended loaded = run("render pnrvsa.toml -o far.svg --co-contraction 3");
    EXPECT_EQ(loaded.code, 2);
    expect_words(loaded.err, {"--co-contraction", "loads of the law"});
    EXPECT_FALSE(fs::exists(folder_ / "far.svg"));
}

TEST_F(Render, NamesTheViewsAndKeepsTheUsersFiles) {
    const Ended unknown = run("render pnrvsa.toml --view deadband -o x.svg");
    EXPECT_EQ(unknown.code, 2);
    expect_words(unknown.err, {"--view", "deadband", "dead-band", "exploded"});
    write("mine.png", "mine");
    const Ended kept = run("render pnrvsa.toml --view law -o mine.png");
    EXPECT_EQ(kept.code, 2);
    expect_words(kept.err, {"mine.png", "--force"});
    EXPECT_EQ(core::read_file(folder_ / "mine.png"), "mine");
    fs::create_symlink(folder_ / "gone", folder_ / "link.png");
    EXPECT_EQ(run("render pnrvsa.toml --view law -o link.png").code, 2) << "a link to nothing";
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.png"));
    EXPECT_EQ(run("render pnrvsa.toml --view law -o law.gif").code, 2);
    EXPECT_EQ(run("render pnrvsa.toml --view gap-map -o gap.svg").code, 2) << "no folder of a case";
}

TEST_F(Render, DrawsTheGapMapOfACase) {
    const std::string folder = FUSEE_SOURCE_DIR "/profiles/models/cam_spring";  // a simulator in Python: seconds, not a minute
    const Ended ended = run("render " + folder + " --view gap-map -o gap.svg");
    ASSERT_EQ(ended.code, 0) << ended.all();
    expect_words(core::read_file(folder_ / "gap.svg"), {"Before: the nominal model", "After: with the effects found", "gap [sigma]"});
}

}  // namespace
}  // namespace fusee::app
