#include "fusee/core/companion.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "fusee/core/error.h"

// A program that answers line by line.
namespace fusee::core {
namespace {

using std::chrono::milliseconds;
using Asked = Companion::End;
constexpr milliseconds kPatience{60'000};

TEST(Companion, AnswersEachLineWithALine) {
    Companion cat({"cat"}, "", {}, "a file");
    std::string answer;
    for (const std::string& line : {std::string("one"), std::string(300'000, 'x'), std::string()}) {  // more than a pipe holds
        ASSERT_EQ(cat.ask(line, kPatience, answer), Asked::kAnswered);
        EXPECT_EQ(answer, line);
    }
}

TEST(Companion, WorksInItsFolderWithItsEnvironment) {
    Companion shell({"sh", "-c", "read line; pwd; echo $WORD"}, "/usr", {"WORD=told"}, "a file");
    std::string answer;
    ASSERT_EQ(shell.ask("where", kPatience, answer), Asked::kAnswered);
    EXPECT_EQ(answer, "/usr");
    ASSERT_EQ(shell.ask("", kPatience, answer), Asked::kAnswered);
    EXPECT_EQ(answer, "told");
}

TEST(Companion, TellsHowAProgramEnded) {
    Companion shell({"sh", "-c", "read line; echo broken >&2; exit 7"}, "", {}, "a file");
    std::string answer;
    EXPECT_EQ(shell.ask("x", kPatience, answer), Asked::kEnded);
    EXPECT_EQ(shell.code(), 7);
    EXPECT_EQ(shell.errors(), "broken\n");
    EXPECT_EQ(shell.ask("x", kPatience, answer), Asked::kEnded);
}

TEST(Companion, EndsAProgramThatDoesNotAnswerInTime) {
    Companion shell({"sh", "-c", "echo waiting >&2; exec sleep 600"}, "", {}, "a file");
    std::string answer;
    EXPECT_EQ(shell.ask("x", milliseconds(100), answer), Asked::kOutOfTime);
    EXPECT_EQ(shell.code(), -1);
}

TEST(Companion, EndsWithItsChildren) {
    std::string child;
    {
        Companion shell({"sh", "-c", "read line; sleep 600 & echo $!; wait"}, "", {}, "a file");
        ASSERT_EQ(shell.ask("x", kPatience, child), Asked::kAnswered);
    }
    for (int i = 0; i < 6000 && ::kill(std::stoi(child), 0) == 0; ++i) std::this_thread::sleep_for(milliseconds(10));
    EXPECT_NE(::kill(std::stoi(child), 0), 0);
}

TEST(Companion, AProgramThatIsMissingNamesTheFile) { EXPECT_THROW(Companion({"no-such-program-of-fusee"}, "", {}, "case.toml"), IoError); }

}  // namespace
}  // namespace fusee::core
