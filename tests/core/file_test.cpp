#include "fusee/core/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "fusee/core/destination.h"
#include "fusee/core/error.h"

namespace fs = std::filesystem;

namespace fusee::core {
namespace {

class FileTest : public ::testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }
    std::size_t entries() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    // One folder for each test and process: ctest runs them side by side.
    fs::path folder_ = fs::path(::testing::TempDir()) / (std::string("fusee_file_") + std::to_string(::getpid()) + "_" +
                                                         ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(FileTest, Sha256OfAbc) {
    // FIPS 180-2, appendix B.1
    EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_F(FileTest, WritesReadsAndLeavesNothingElse) {
    write_file(folder_ / "a", "one");
    write_file(folder_ / "a", "two");
    EXPECT_EQ(read_file(folder_ / "a"), "two");
    EXPECT_EQ(entries(), 1u);
    EXPECT_THROW((void)read_file(folder_ / "missing"), IoError);
    EXPECT_THROW((void)read_file(folder_), IoError);
    EXPECT_THROW(write_file(folder_ / "no" / "such" / "folder", "x"), IoError);
}

TEST_F(FileTest, OnlyRegularFilesAreRead) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    for (const fs::path& path : {folder_ / "pipe", fs::path("/dev/zero"), fs::path("/dev/null")}) {
        try {
            (void)read_file(path, 1000);
            FAIL() << path;
        } catch (const IoError& e) {
            EXPECT_NE(std::string(e.what()).find("only regular files are read"), std::string::npos) << e.what();
        }
    }
    write_file(folder_ / "a", "one");
    fs::create_symlink("a", folder_ / "link");
    EXPECT_EQ(read_file(folder_ / "link"), "one");
}

TEST_F(FileTest, AFolderInTheWayIsRefusedAndNothingIsLeft) {
    fs::create_directories(folder_ / "a");
    EXPECT_THROW(write_file(folder_ / "a", "x"), IoError);
    EXPECT_EQ(entries(), 1u);
}

TEST_F(FileTest, WhatCannotBeWrittenIsKnownBefore) {
    write_file(folder_ / "a", "one");
    require_writable(folder_ / "a");
    require_writable(folder_ / "new");
    EXPECT_EQ(read_file(folder_ / "a"), "one");
    EXPECT_EQ(entries(), 1u);
    for (const char* wrong : {"", "no/such/folder", "a/b"}) EXPECT_THROW(require_writable(folder_ / wrong), IoError) << wrong;
}

TEST_F(FileTest, MakesFoldersUnlessAFileIsInTheWay) {
    make_folder(folder_ / "a" / "b");
    make_folder(folder_ / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder_ / "a" / "b"));
    write_file(folder_ / "c", "x");
    EXPECT_THROW(make_folder(folder_ / "c"), IoError);
    EXPECT_THROW(make_folder(folder_ / "c" / "d"), IoError);
}

TEST_F(FileTest, StagedFolderReplacesAsAWhole) {
    {
        StagedFolder first(folder_ / "out");
        write_file(first.path() / "old", "1");
        first.commit();
    }
    {
        StagedFolder second(folder_ / "out");
        write_file(second.path() / "new", "2");
        second.commit();
    }
    EXPECT_TRUE(fs::exists(folder_ / "out" / "new"));
    EXPECT_FALSE(fs::exists(folder_ / "out" / "old"));
    EXPECT_EQ(entries(), 1u);
}

TEST_F(FileTest, StagedFolderLeftUncommittedLeavesTheEarlierOne) {
    fs::create_directories(folder_ / "out");
    write_file(folder_ / "out" / "old", "1");
    {
        StagedFolder staged(folder_ / "out");
        write_file(staged.path() / "half", "x");
    }
    EXPECT_EQ(read_file(folder_ / "out" / "old"), "1");
    EXPECT_EQ(entries(), 1u);
}

TEST_F(FileTest, StagedFolderClearsAwayWhatAKilledProcessLeft) {
    const fs::path orphan = folder_ / ".out.partial-4194303-0", alive = folder_ / (".out.partial-" + std::to_string(::getpid()) + "-99");
    fs::create_directories(orphan);  // 4194303 is Linux's highest process number: practically never in use
    fs::create_directories(alive);
    { const StagedFolder staged(folder_ / "out"); }
    EXPECT_FALSE(fs::exists(orphan));
    EXPECT_TRUE(fs::exists(alive));
    const fs::path earlier = folder_ / ".out.earlier-4194303-1";  // killed between its two renames
    fs::create_directories(earlier);
    write_file(earlier / "kept", "1");
    { const StagedFolder staged(folder_ / "out"); }
    EXPECT_EQ(read_file(folder_ / "out" / "kept"), "1");
    EXPECT_FALSE(fs::exists(earlier));
}

}  // namespace
}  // namespace fusee::core
