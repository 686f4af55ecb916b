#include "fusee/core/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

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
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    EXPECT_THROW(require_writable(folder_ / "pipe"), IoError) << "a pipe is not replaced by a file";
    EXPECT_THROW(require_writable("/dev/null"), IoError);
}

TEST_F(FileTest, MakesFoldersUnlessAFileIsInTheWay) {
    make_folder(folder_ / "a" / "b");
    make_folder(folder_ / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder_ / "a" / "b"));
    write_file(folder_ / "c", "x");
    EXPECT_THROW(make_folder(folder_ / "c"), IoError);
    EXPECT_THROW(make_folder(folder_ / "c" / "d"), IoError);
}

TEST_F(FileTest, AFailureNamesItsCause) {
    const auto cause_of = [](const auto& write) -> std::string {
        try {
            write();
        } catch (const IoError& e) {
            return e.what();
        }
        return "none";
    };
    const fs::path missing = folder_ / "no" / "such" / "folder";
    EXPECT_EQ(cause_of([&] { write_file(missing, "x"); }), missing.string() + ": cannot be written: No such file or directory");
    EXPECT_EQ(cause_of([&] { require_writable(missing); }), missing.string() + ": cannot be written: No such file or directory");
}

TEST_F(FileTest, AFileThatTheUserNamesIsReplacedByForceOnly) {
    require_new_file(folder_ / "new", false);
    EXPECT_EQ(entries(), 0u);
    write_file(folder_ / "a", "mine");
    EXPECT_THROW(require_new_file(folder_ / "a", false), IoError);
    require_new_file(folder_ / "a", true);
    EXPECT_EQ(read_file(folder_ / "a"), "mine");
}

// 4194303 is Linux's highest process number: practically never in use.
TEST_F(FileTest, WhatAKilledWriteLeftIsRemoved) {
    const std::string own = ".a.part-" + std::to_string(::getpid()) + "-0";
    for (const std::string& name : {std::string(".a.part-4194303-0"), std::string(".b.part-4194303-0"), own})
        write_file(folder_ / name, "x");
    require_writable(folder_ / "a");
    EXPECT_FALSE(fs::exists(folder_ / ".a.part-4194303-0"));
    EXPECT_TRUE(fs::exists(folder_ / ".b.part-4194303-0")) << "of another file";
    EXPECT_TRUE(fs::exists(folder_ / own));
}

}  // namespace
}  // namespace fusee::core
