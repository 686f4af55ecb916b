#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"

namespace fs = std::filesystem;

namespace fusee::core {
namespace {

class TemporaryFolderTest : public ::testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "fusee_temporary_XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        parent_ = pattern;
    }
    void TearDown() override { fs::remove_all(parent_); }
    [[nodiscard]] std::ptrdiff_t entries() const { return std::distance(fs::directory_iterator(parent_), fs::directory_iterator()); }
    fs::path parent_;
};

TEST_F(TemporaryFolderTest, GoesWithAllThatItHolds) {
    {
        const TemporaryFolder first(parent_, "x-"), second(parent_, "x-");
        EXPECT_NE(first.path(), second.path());
        write_file(first.path() / "a", "1");
        EXPECT_EQ(entries(), 2);
    }
    EXPECT_EQ(entries(), 0);
}

TEST_F(TemporaryFolderTest, WhatAKilledProcessLeftIsRemovedByTheNextOne) {
    const pid_t child = ::fork();
    if (child == 0) {
        const TemporaryFolder left(parent_, "x-");
        write_file(left.path() / "a", "1");
        ::raise(SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
    EXPECT_EQ(entries(), 1);
    fs::create_directories(parent_ / "x-notes");  // five characters
    fs::create_directories(parent_ / "x-abc.de");
    const TemporaryFolder alive(parent_, "x-"), next(parent_, "x-");
    EXPECT_EQ(entries(), 4) << "two in use, two that are no temporary folders";
}

TEST_F(TemporaryFolderTest, AMissingTmpdirIsNamed) {
    const char* before = std::getenv("TMPDIR");
    const std::string kept = before == nullptr ? "" : before;
    ::setenv("TMPDIR", (parent_ / "missing").c_str(), 1);
    try {
        const TemporaryFolder folder;
        ADD_FAILURE();
    } catch (const IoError& e) {
        EXPECT_NE(std::string(e.what()).find("TMPDIR=" + (parent_ / "missing").string()), std::string::npos) << e.what();
    }
    if (before == nullptr)
        ::unsetenv("TMPDIR");
    else
        ::setenv("TMPDIR", kept.c_str(), 1);
    EXPECT_THROW(TemporaryFolder(parent_ / "missing", "x-"), IoError);
}

}  // namespace
}  // namespace fusee::core
