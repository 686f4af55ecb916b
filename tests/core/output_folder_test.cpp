#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <map>
#include <thread>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"

namespace fs = std::filesystem;

namespace fusee::core {
namespace {

using Files = std::map<std::string, std::string>;

class OutputFolderTest : public ::testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "fusee_output_XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
        out_ = folder_ / "out";
        write_file(folder_ / "a.toml", "a");
        write_file(folder_ / "b.toml", "b");
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] OutputRun run(const std::string& command = "make", const std::string& source = "a.toml") const {
        return {command, folder_ / source, false, {}, {}, false, false};
    }
    void put(const Files& files, const OutputRun& run) const {
        OutputFolder output(out_, run);
        for (const auto& [name, bytes] : files) {
            fs::create_directories((output.path() / name).parent_path());
            write_file(output.path() / name, bytes);
        }
        output.commit();
    }
    /// Every entry below the target but the manifest.
    [[nodiscard]] Files standing() const {
        Files files;
        for (const auto& entry : fs::recursive_directory_iterator(out_))
            if (entry.path().filename() != kManifestName)
                files[entry.path().lexically_relative(out_).string()] = entry.is_regular_file() ? read_file(entry.path()) : "";
        return files;
    }
    /// Refuses, names all of `words`, and leaves every byte as it was.
    void expect_refused(const Files& files, const OutputRun& run, const std::vector<std::string>& words) const {
        const Files before = standing();
        try {
            put(files, run);
            ADD_FAILURE() << "not refused";
        } catch (const IoError& e) {
            for (const std::string& word : words)
                EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << word << " in " << e.what();
        }
        EXPECT_EQ(standing(), before);
    }

    fs::path folder_, out_;
};

TEST_F(OutputFolderTest, KeepsWhatTheUserPutThere) {
    put({{"k_se.stl", "1"}, {"k_se.step", "1"}}, run());
    write_file(out_ / "notes.txt", "mine");
    fs::create_directories(out_ / "sliced");
    write_file(out_ / "sliced" / "k_se.gcode", "mine too");
    put({{"k_se.stl", "2"}}, run());
    EXPECT_EQ(standing(), (Files{{"k_se.stl", "2"}, {"notes.txt", "mine"}, {"sliced", ""}, {"sliced/k_se.gcode", "mine too"}}));
}

TEST_F(OutputFolderTest, UncommittedItLeavesNothing) {
    {
        OutputFolder output(out_, run());
        write_file(output.path() / "half", "x");
    }
    EXPECT_FALSE(fs::exists(out_));
    put({{"k_se.stl", "1"}}, run());
    {
        OutputFolder output(out_, run());
        write_file(output.path() / "half", "x");
    }
    EXPECT_EQ(standing(), (Files{{"k_se.stl", "1"}}));
    { const OutputFolder never_used(folder_ / "other", run()); }
    EXPECT_FALSE(fs::exists(folder_ / "other"));
}

TEST_F(OutputFolderTest, AFolderThatFuseeDidNotMakeIsRefusedBeforeTheWork) {
    fs::create_directories(out_);
    { const OutputFolder empty(out_, run()); }
    write_file(out_ / "main.cpp", "mine");
    EXPECT_THROW(OutputFolder(out_, run()), IoError);
    expect_refused({{"k_se.stl", "1"}}, run(), {out_.string(), "did not make this folder", "main.cpp"});
    OutputRun forced = run();
    forced.force = true;
    expect_refused({{"k_se.stl", "1"}}, forced, {"did not make this folder"});
    EXPECT_THROW(OutputFolder(out_ / "main.cpp", run()), IoError) << "a file";
    EXPECT_THROW(OutputFolder("", run()), IoError);
}

TEST_F(OutputFolderTest, AnotherProfilesFolderIsRefusedByNameUnlessForced) {
    put({{"k_se.stl", "1"}, {"k_pe.stl", "1"}}, run());
    put({{"simulation.json", "1"}}, run("simulate"));
    write_file(out_ / "notes.txt", "mine");
    EXPECT_THROW(OutputFolder(out_, run("make", "b.toml")), IoError);
    expect_refused({{"k_se.stl", "2"}}, run("make", "b.toml"), {"a.toml", "b.toml", "--force"});
    OutputRun forced = run("make", "b.toml");
    forced.force = true;
    put({{"k_se.stl", "2"}}, forced);
    EXPECT_EQ(standing(), (Files{{"k_se.stl", "2"}, {"notes.txt", "mine"}}));
    expect_refused({{"k_se.stl", "3"}}, run(), {"a.toml", "b.toml"});
}

TEST_F(OutputFolderTest, CommandsOfOneSourceShareAFolder) {
    put({{"k_se.stl", "1"}, {"simulation.json", "1"}}, run());
    put({{"simulation.json", "2"}, {"at.csv", "2"}}, run("simulate"));
    EXPECT_EQ(standing(), (Files{{"k_se.stl", "1"}, {"simulation.json", "2"}, {"at.csv", "2"}}));
    put({{"simulation.json", "3"}}, run("simulate"));
    EXPECT_EQ(standing(), (Files{{"k_se.stl", "1"}, {"simulation.json", "3"}}));
}

TEST_F(OutputFolderTest, WhatWasChangedIsReplacedByForceOnly) {
    put({{"k_se.scad", "1"}, {"old.stl", "1"}}, run());
    write_file(out_ / "k_se.scad", "edited");
    EXPECT_THROW(OutputFolder(out_, run()), IoError);
    expect_refused({{"k_se.scad", "2"}}, run(), {"out/k_se.scad", "changed", "--force"});
    OutputRun forced = run();
    forced.force = true;
    put({{"k_se.scad", "2"}}, forced);
    EXPECT_EQ(standing(), (Files{{"k_se.scad", "2"}}));
}

TEST_F(OutputFolderTest, AFileThatFuseeDidNotMakeIsNeverReplaced) {
    put({{"k_se.stl", "1"}}, run());
    write_file(out_ / "k_se.step", "mine");
    OutputRun forced = run();
    forced.force = true;
    expect_refused({{"k_se.step", "2"}, {"k_se.stl", "2"}}, forced, {"out/k_se.step", "did not make"});
    forced.files = {"k_se.step"};
    EXPECT_THROW(OutputFolder(out_, forced), IoError) << "known before the work";
    fs::remove(out_ / "k_se.step");
    fs::create_directory(out_ / "k_se.step");
    expect_refused({{"k_se.step", "2"}}, run(), {"out/k_se.step", "not a regular file"});
    fs::remove(out_ / "k_se.step");
    write_file(folder_ / "elsewhere", "mine");
    fs::create_symlink(folder_ / "elsewhere", out_ / "k_se.step");
    expect_refused({{"k_se.step", "2"}}, run(), {"not a regular file"});
    EXPECT_EQ(read_file(folder_ / "elsewhere"), "mine");
}

TEST_F(OutputFolderTest, ASourceThatIsALinkStaysOneSource) {
    fs::create_symlink("a.toml", folder_ / "link.toml");
    put({{"k_se.stl", "1"}}, run("make", "link.toml"));
    fs::remove(folder_ / "link.toml");
    fs::create_symlink("b.toml", folder_ / "link.toml");
    put({{"k_se.stl", "2"}}, run("make", "link.toml"));
    expect_refused({{"k_se.stl", "3"}}, run("make", "b.toml"), {"link.toml"});
}

TEST_F(OutputFolderTest, AFilledSheetIsNeverReplaced) {
    OutputRun coupons = run("coupons");
    coupons.sheets = {"COUPON.csv"};
    put({{"COUPON.csv", "empty"}, {"plate.stl", "1"}}, coupons);
    put({{"COUPON.csv", "empty 2"}, {"plate.stl", "2"}}, coupons);
    EXPECT_EQ(read_file(out_ / "COUPON.csv"), "empty 2") << "nothing was filled in";
    write_file(out_ / "COUPON.csv", "filled");
    coupons.force = true;
    EXPECT_THROW(OutputFolder(out_, coupons), IoError);
    expect_refused({{"COUPON.csv", "empty"}, {"plate.stl", "3"}}, coupons, {"out/COUPON.csv", "sheet", "Move it"});
    coupons.source = folder_ / "b.toml";
    expect_refused({{"COUPON.csv", "empty"}}, coupons, {"out/COUPON.csv", "sheet"});
    coupons.sheets.clear();
    put({{"plate.stl", "4"}}, coupons);
    EXPECT_EQ(standing(), (Files{{"COUPON.csv", "filled"}, {"plate.stl", "4"}})) << "no longer made, but filled in";
}

TEST_F(OutputFolderTest, FoldersInsideComeAndGo) {
    put({{"case_1/case.toml", "1"}, {"case_2/heldout/log.csv", "1"}}, run());
    put({{"case_1/case.toml", "2"}}, run());
    EXPECT_EQ(standing(), (Files{{"case_1", ""}, {"case_1/case.toml", "2"}}));
    fs::remove_all(out_ / "case_1");
    fs::create_directories(folder_ / "elsewhere");
    fs::create_directory_symlink(folder_ / "elsewhere", out_ / "case_1");
    expect_refused({{"case_1/case.toml", "3"}}, run(), {"case_1", "is a link"});
    EXPECT_TRUE(fs::is_empty(folder_ / "elsewhere"));
}

TEST_F(OutputFolderTest, ASharedFolderTakesSeveralSources) {
    fs::create_directories(out_);
    write_file(out_ / "notes.txt", "mine");
    OutputRun first = run("check"), second = run("check", "b.toml");
    first.many_sources = second.many_sources = true;
    EXPECT_THROW(OutputFolder(out_, first), IoError);
    first.among_others = second.among_others = true;
    put({{"a_check.3mf", "1"}}, first);
    put({{"b_check.3mf", "1"}}, second);
    EXPECT_EQ(standing(), (Files{{"a_check.3mf", "1"}, {"b_check.3mf", "1"}, {"notes.txt", "mine"}}));
    expect_refused({{"a_check.3mf", "2"}}, second, {"a_check.3mf", "a.toml"});
    expect_refused({{"notes.txt", "2"}}, second, {"notes.txt", "did not make"});
}

TEST_F(OutputFolderTest, AFolderThatIsItsOwnSourceTakesBoth) {
    put({{"case.toml", "1"}}, run("case-template"));
    OutputRun diagnose{"diagnose", out_, false, {}, {}, false, false};
    put({{"diagnosis.json", "1"}}, diagnose);
    put({{"case.toml", "1"}}, run("case-template"));
    EXPECT_EQ(standing(), (Files{{"case.toml", "1"}, {"diagnosis.json", "1"}}));
}

TEST_F(OutputFolderTest, AMovedTreeKeepsItsOwner) {
    put({{"k_se.stl", "1"}}, run());
    const fs::path moved = folder_.string() + "_moved";
    fs::rename(folder_, moved);
    folder_ = moved;
    out_ = moved / "out";
    put({{"k_se.stl", "2"}}, run());
    EXPECT_EQ(standing(), (Files{{"k_se.stl", "2"}}));
}

TEST_F(OutputFolderTest, ADamagedManifestStopsEverything) {
    put({{"k_se.stl", "1"}}, run());
    write_file(folder_ / "victim", "mine");
    const std::string entry = R"("command":"make","source":"../a.toml","sha256":")" + sha256_hex("mine") + R"("})";
    const std::string outside = "{" + entry + "}}";
    const std::vector<std::string> damaged{"{",
                                           "[]",
                                           std::string(200000, '['),
                                           R"({"files":{"x":3}})",
                                           R"({"files":{"../victim":)" + outside,
                                           R"({"files":{")" + (folder_ / "victim").string() + R"(":)" + outside};
    for (const std::string& text : damaged) {
        write_file(out_ / kManifestName, text);
        expect_refused({{"k_se.stl", "2"}}, run(), {kManifestName, "damaged"});
    }
    EXPECT_EQ(read_file(folder_ / "victim"), "mine");
}

TEST_F(OutputFolderTest, NamesThatAreNoUtf8AreKept) {
    const std::string name = "\xff%41_check.3mf";
    put({{name, "1"}}, run());
    put({{name, "2"}}, run());
    EXPECT_EQ(standing(), (Files{{name, "2"}}));
}

TEST_F(OutputFolderTest, RunsAtTheSameTimeAllEndWell) {
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([this, i] {
            for (int k = 0; k < 5; ++k) put({{"a", std::to_string(i)}, {"b", std::to_string(i)}}, run());
        });
    for (std::thread& thread : threads) thread.join();
    const Files end = standing();
    EXPECT_EQ(end.size(), 2u);
    EXPECT_EQ(end.at("a"), end.at("b"));
}

// The folder that the user names may be a link; below it a link, even to nothing, and a file are refused.
TEST_F(OutputFolderTest, ALinkIsFollowedOnlyWhereTheUserNamesIt) {
    const fs::path victim = folder_ / "victim", named = folder_ / "named";
    fs::create_directories(victim);
    fs::create_directories(out_);
    fs::create_directory_symlink(out_, named);
    {
        OutputFolder output(named, "design", run());
        write_file(output.path() / "k_se.stl", "1");
        output.commit();
    }
    EXPECT_EQ(read_file(out_ / "design/k_se.stl"), "1");
    const std::vector<std::pair<std::string, fs::path>> links{
        {"folder", victim}, {"nothing", folder_ / "gone"}, {"file", folder_ / "a.toml"}};
    for (const auto& [name, to] : links) {
        fs::create_symlink(to, out_ / name);
        EXPECT_THROW(OutputFolder(named, name, run()), IoError) << name;
        EXPECT_THROW(OutputFolder(named, fs::path(name) / "deeper", run()), IoError) << name;
    }
    write_file(out_ / "plain", "mine");
    EXPECT_THROW(OutputFolder(named, "plain", run()), IoError);
    EXPECT_TRUE(fs::is_empty(victim));
    EXPECT_FALSE(fs::exists(folder_ / "gone"));
    EXPECT_EQ(read_file(folder_ / "a.toml"), "a");
}

TEST_F(OutputFolderTest, ALinkThatAppearsWhileItRunsIsNotFollowed) {
    const fs::path victim = folder_ / "victim";
    fs::create_directories(victim);
    write_file(victim / "k_se.stl", "mine");
    OutputFolder output(out_, "design", run());
    const fs::path staging = output.path();
    write_file(staging / "k_se.stl", "1");
    fs::rename(out_ / "design", out_ / "moved");
    fs::create_directories(victim / staging.filename());  // the attacker knows its name
    fs::create_directory_symlink(victim, out_ / "design");
    EXPECT_THROW(write_file(staging / "k_pe.stl", "1"), IoError);
    EXPECT_THROW(output.commit(), IoError);
    EXPECT_EQ(read_file(victim / "k_se.stl"), "mine");
    EXPECT_TRUE(fs::is_empty(victim / staging.filename()));
}

TEST_F(OutputFolderTest, AHardLinkIsNotWrittenThrough) {
    put({{"k_se.stl", "1"}}, run());
    fs::create_hard_link(out_ / "k_se.stl", folder_ / "mine.stl");
    put({{"k_se.stl", "2"}}, run());
    EXPECT_EQ(read_file(folder_ / "mine.stl"), "1");
    EXPECT_EQ(read_file(out_ / "k_se.stl"), "2");
}

TEST_F(OutputFolderTest, AForgedManifestReachesNothingThroughLinks) {
    put({{"k_se.stl", "1"}}, run());
    const fs::path victim = folder_ / "victim";
    fs::create_directories(victim);
    write_file(victim / "thesis", "mine");
    fs::create_directory_symlink(victim, out_ / "link");
    fs::create_symlink(victim / "thesis", out_ / "thesis");
    for (const std::string name : {"link/thesis", "thesis"}) {
        write_file(out_ / kManifestName, R"({"files":{")" + name + R"(":{"command":"make","source":"../a.toml","sha256":")" +
                                             sha256_hex("mine") + R"("},"k_se.stl":{"command":"make","source":"../a.toml","sha256":")" +
                                             sha256_hex("1") + R"("}}})");
        try {
            put({{"k_se.stl", "1"}}, run());
        } catch (const IoError&) {  // refused, or the name is left alone
        }
        EXPECT_EQ(read_file(victim / "thesis"), "mine");
        EXPECT_TRUE(fs::is_symlink(out_ / "thesis"));
    }
    fs::remove(out_ / kManifestName);
    fs::create_symlink(victim / "thesis", out_ / kManifestName);
    expect_refused({{"k_se.stl", "2"}}, run(), {kManifestName, "not a file"});
    EXPECT_EQ(read_file(victim / "thesis"), "mine");
}

TEST_F(OutputFolderTest, AFileThatAppearsWhileItRunsIsNotReplaced) {
    const OpenFolder place = OpenFolder::named(folder_);
    write_file(folder_ / "new", "1");
    write_file(folder_ / "taken", "mine");
    EXPECT_THROW(place.move("new", place, "taken", false), IoError);
    EXPECT_EQ(read_file(folder_ / "taken"), "mine");
    place.move("new", place, "free", false);
    EXPECT_EQ(read_file(folder_ / "free"), "1");
}

// The name is that of a staging folder; a user's folder lets others in.
TEST_F(OutputFolderTest, AFolderOfTheUsersWithAScratchNameStays) {
    put({{"k_se.stl", "1"}}, run());
    fs::create_directories(out_ / ".fusee-staging-abcdef");
    write_file(out_ / ".fusee-staging-abcdef/thesis", "mine");
    put({{"k_se.stl", "2"}}, run());
    EXPECT_EQ(read_file(out_ / ".fusee-staging-abcdef/thesis"), "mine");
}

/// Runs `work` in a separate process and kills it after so many microseconds.
void killed_after(useconds_t delay, const std::function<void()>& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        ::_exit(0);
    }
    ::usleep(delay);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
}

TEST_F(OutputFolderTest, KilledAtAnyMomentTheNextRunCompletesIt) {
    const auto files = [](int i) {
        Files all{{"report.html", std::to_string(i)}, {"folder/" + std::to_string(i % 3), "x"}};
        for (int k = 0; k < 3; ++k) all["k_" + std::to_string(k + i % 2)] = std::to_string(i);
        return all;
    };
    put(files(0), run());
    write_file(out_ / "notes.txt", "mine");
    for (int i = 1; i < 20; ++i) {
        const useconds_t delay = 200 * static_cast<useconds_t>(i * i);  // 0.2 to 72 ms: from the first file to the last
        killed_after(delay, [&] { put(files(i), run()); });
        put(files(i), run());
        Files expected = files(i);
        expected["notes.txt"] = "mine";
        expected["folder"] = "";
        ASSERT_EQ(standing(), expected) << "killed after " << delay << " us";
    }
}

}  // namespace
}  // namespace fusee::core
