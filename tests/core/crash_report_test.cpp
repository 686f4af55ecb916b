#include "fusee/core/crash_report.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "core/sanitizer.h"
#include "fusee/core/file.h"
#include "pipeline/fixture.h"

namespace fusee::core {
namespace {

namespace fs = std::filesystem;

// The handler ends on a stack of its own, where the address sanitizer of clang 14 fails a check: asan_poisoning.cpp:35.
const char* const kNotChecked = "not checked: the address sanitizer cannot end on another stack";

class CrashReport : public fixtures::TempFolder {
protected:
    /// In a child process: the handlers and the working folder are those of a process.
    void crash_in_folder(const std::string& input, int signal) const {
        fs::current_path(folder_);
        begin_crash_reports("fusee test", {"fusee", "make", input, "--out=/somewhere/else", "it's"});
        (void)read_file(input);
        note_throw("a type");
        (void)std::raise(signal);
    }
    [[nodiscard]] fs::path report() const {
        for (const auto& entry : fs::directory_iterator(folder_))
            if (entry.path().filename().string().starts_with("fusee-crash-")) return entry.path();
        return {};
    }
};

TEST_F(CrashReport, IsNotWrittenBeforeItIsPrepared) { EXPECT_STREQ(write_crash_report("nothing"), ""); }

TEST_F(CrashReport, OfAFatalSignalHoldsCommandInputsAndStackAndEndsWith3) {
    if (kAddressSanitizer) GTEST_SKIP() << kNotChecked;
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) {
        const fs::path input = write("profiles/a b.toml", "x = 1\n");
        EXPECT_EXIT(crash_in_folder(input.string(), signal), testing::ExitedWithCode(3), "internal error.*\n.*fusee-crash-");
        const fs::path folder = report();
        ASSERT_FALSE(folder.empty());
        EXPECT_EQ(read_file(folder / "inputs" / input.string().substr(1)), "x = 1\n");
        EXPECT_EQ(read_file(folder / "inputs.txt"), "copied: " + input.string() + "\n");
        EXPECT_NE(read_file(folder / "README.txt").find("Program: fusee test"), std::string::npos);
        EXPECT_NE(read_file(folder / "stack.txt").find("Thrown: a type"), std::string::npos);
        const std::string script = read_file(folder / "reproduce.sh");
        EXPECT_NE(script.find(" 'make' \"$here/inputs\"'" + input.string() + "' '--out='\"$here/inputs\"'/somewhere/else' 'it'\\''s'\n"),
                  std::string::npos)
            << script;
        fs::remove_all(folder);
    }
}

TEST_F(CrashReport, GoesToTheFolderForTemporaryFilesWhereTheWorkingFolderCannotBeWritten) {
    if (kAddressSanitizer) GTEST_SKIP() << kNotChecked;
    const fs::path temporary = folder_ / "tmp";
    fs::create_directory(temporary);
    const auto crash = [&] {
        ::setenv("TMPDIR", temporary.c_str(), 1);
        fs::current_path("/proc");
        begin_crash_reports("fusee test", {"fusee"});
        (void)std::raise(SIGSEGV);
    };
    EXPECT_EXIT(crash(), testing::ExitedWithCode(3), "tmp/fusee-crash-");
    EXPECT_FALSE(fs::is_empty(temporary));
}

}  // namespace
}  // namespace fusee::core
