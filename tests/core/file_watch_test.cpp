#include "fusee/core/file_watch.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"

namespace fs = std::filesystem;

namespace fusee::core {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds kNow{0}, kLong{2000}, kQuiet{5};

TEST(FileWatch, SeesASaveAReplacementAndANewFile) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.toml", other = folder.path() / "b.toml";
    FileWatch watch;
    watch.watch({file});
    EXPECT_FALSE(watch.wait(kNow, kQuiet));
    write_file(file, "1");  // writes a temporary name and renames it
    EXPECT_TRUE(watch.wait(kLong, kQuiet));
    write_file(other, "1");
    EXPECT_FALSE(watch.wait(milliseconds(50), kQuiet)) << "another file of the folder";
    std::filesystem::rename(other, file);
    EXPECT_TRUE(watch.wait(kLong, kQuiet));
    std::filesystem::remove(file);
    EXPECT_TRUE(watch.wait(kLong, kQuiet));
}

TEST(FileWatch, ManyWritesAreOneSave) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.toml";
    FileWatch watch;
    watch.watch({file});
    for (int i = 0; i < 20; ++i) write_file(file, std::to_string(i));
    EXPECT_TRUE(watch.wait(kLong, milliseconds(50)));
    EXPECT_FALSE(watch.wait(milliseconds(50), kQuiet));
}

TEST(FileWatch, AnOtherListReplacesTheFirst) {
    const TemporaryFolder first, second;
    FileWatch watch;
    watch.watch({first.path() / "a"});
    watch.watch({second.path() / "a"});
    write_file(first.path() / "a", "1");
    EXPECT_FALSE(watch.wait(milliseconds(50), kQuiet));
    write_file(second.path() / "a", "1");
    EXPECT_TRUE(watch.wait(kLong, kQuiet));
    EXPECT_THROW(watch.watch({first.path() / "missing" / "a"}), IoError);
}

/// Takes what has happened so far, and begins anew.
class Links : public testing::Test {
protected:
    Links() : at_(folder_.path()) {
        for (const char* each : {"one", "two"}) {
            fs::create_directory(at_ / each);
            write_file(at_ / each / "a.toml", each);
        }
    }
    void watch(const fs::path& file) {
        watch_.watch({file});
        ASSERT_FALSE(watch_.wait(kNow, kQuiet));
    }
    [[nodiscard]] bool saved() { return watch_.wait(kLong, kQuiet); }
    [[nodiscard]] bool still() { return !watch_.wait(milliseconds(50), kQuiet); }
    void link(const fs::path& to, const fs::path& name) {  // as ln -sfn and Kubernetes do: a new link renamed over the old one
        fs::create_symlink(to, at_ / "new");
        fs::rename(at_ / "new", at_ / name);
    }

    TemporaryFolder folder_;
    fs::path at_;
    FileWatch watch_;
};

TEST_F(Links, TheTargetOfALinkIsSaved) {
    link("one/a.toml", "second");
    link("second", "a.toml");
    watch(at_ / "a.toml");
    std::ofstream(at_ / "one/a.toml") << "in place";
    EXPECT_TRUE(saved());
    write_file(at_ / "one/a.toml", "by rename");
    EXPECT_TRUE(saved());
    EXPECT_TRUE(still());
}

TEST_F(Links, ALinkOfAnyLevelLeadsElsewhere) {
    link("one", "..data");
    link("..data", "folder");
    fs::create_symlink("folder/a.toml", at_ / "a.toml");
    watch(at_ / "a.toml");
    link("two", "..data");
    EXPECT_TRUE(saved());
    std::ofstream(at_ / "one/a.toml") << "no longer meant";
    EXPECT_TRUE(still());
    std::ofstream(at_ / "two/a.toml") << "meant now";
    EXPECT_TRUE(saved());
}

TEST_F(Links, AFolderIsReplaced) {
    watch(at_ / "one/a.toml");
    fs::rename(at_ / "one", at_ / "old");
    EXPECT_TRUE(saved());
    EXPECT_TRUE(still());
    fs::rename(at_ / "two", at_ / "one");
    EXPECT_TRUE(saved());
    std::ofstream(at_ / "one/a.toml") << "in the new one";
    EXPECT_TRUE(saved());
    EXPECT_TRUE(still());
}

// The change falls between the last wait and a new list of files.
TEST_F(Links, AChangeBeforeANewListIsNotLost) {
    watch(at_ / "one/a.toml");
    fs::rename(at_ / "one", at_ / "old");
    fs::rename(at_ / "two", at_ / "one");
    watch_.watch({at_ / "one/a.toml", at_ / "b.toml"});
    EXPECT_TRUE(saved());
}

TEST_F(Links, AFileIsSavedByAnotherName) {
    fs::create_hard_link(at_ / "one/a.toml", at_ / "other");
    watch(at_ / "one/a.toml");
    std::ofstream(at_ / "other") << "by its other name";
    EXPECT_TRUE(saved());
}

}  // namespace
}  // namespace fusee::core
