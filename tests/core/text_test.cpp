#include "fusee/core/text.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fusee/core/error.h"

namespace fusee::core {
namespace {

TEST(Printable, LeavesWhatIsPrintable) {
    EXPECT_EQ(printable(""), "");
    EXPECT_EQ(printable("profiles/\xC3\xA4\xE2\x82\xAC\xF0\x9F\x94\xA9 a.toml"), "profiles/\xC3\xA4\xE2\x82\xAC\xF0\x9F\x94\xA9 a.toml");
}

TEST(Printable, ShowsWhatATerminalWouldObey) {
    EXPECT_EQ(printable("a\x1b[2Jb\n\t\r\x7f"), "a\\x1b[2Jb\\n\\t\\x0d\\x7f");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
    EXPECT_EQ(printable("\xC2\x9B"), "\\x9b") << "the C1 control that begins a sequence as ESC [ does";
    EXPECT_EQ(printable("\xE2\x80\xAE"), "\\u202e") << "text from right to left";
}

TEST(Printable, ShowsWhatIsNotSeen) {
    for (const auto& [text, shown] : {std::pair{"\xE2\x80\xAE", "\\u202e"},
                                      {"\xE2\x81\xA6", "\\u2066"},
                                      {"\xE2\x80\x8F", "\\u200f"},
                                      {"\xEF\xBB\xBF", "\\ufeff"},
                                      {"\xE2\x80\x8B", "\\u200b"},
                                      {"\xD8\x9C", "\\u061c"},
                                      {"\xC2\xAD", "\\u00ad"},
                                      {"\xF3\xA0\x81\x81", "\\ue0041"}})
        EXPECT_EQ(printable(std::string("k") + text + "se"), std::string("k") + shown + "se");
}

TEST(PrintableLines, LeaveLineEndsAndTabs) {
    EXPECT_EQ(printable_lines("a\tb\n\n\x1b[31mc\r\n"), "a\tb\n\n\\x1b[31mc\\x0d\n");
    EXPECT_EQ(printable_lines(""), "");
}

TEST(PlainName, RefusesWhatIsNotSeen) {
    EXPECT_NO_THROW(require_plain_name("out/\xE2\x80\xAE/\xC3\xA4 b.stl")) << "folders are the user's";
    EXPECT_THROW(require_plain_name("out/a\xE2\x80\xAElts.3mf"), IoError);
    EXPECT_THROW(require_plain_name("a\x1b[2J.3mf"), IoError);
}

TEST(Printable, ShowsBytesThatAreNoUtf8) {
    EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
    EXPECT_EQ(printable("\xC3"), "\\xc3") << "cut short";
    EXPECT_EQ(printable("\xC0\x80"), "\\xc0\\x80") << "a longer form of NUL";
    EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
}

TEST(Printable, CutsWhatIsLong) {
    EXPECT_EQ(printable("abcd", 4), "abcd");
    EXPECT_EQ(printable("abcde", 4), "abcd... (5 characters)");
    EXPECT_EQ(printable("\xC3\xA4\xC3\xA4\xC3\xA4", 2), "\xC3\xA4\xC3\xA4... (3 characters)");
}

TEST(Lower, ChangesAsciiLettersOnly) { EXPECT_EQ(lower("N\xC3\x84gel-10 KG"), "n\xC3\x84gel-10 kg"); }

TEST(ShellWord, HasQuotesOnlyWhereTheyAreNeeded) {
    EXPECT_EQ(shell_word("/tmp/model-1.py"), "/tmp/model-1.py");
    EXPECT_EQ(shell_word("a b"), "'a b'");
    EXPECT_EQ(shell_word("it's;$x"), "'it'\\''s;$x'");
    EXPECT_EQ(shell_word(""), "''");
    EXPECT_EQ(shell_word("~"), "'~'");
}

TEST(FindControl, PassesOverLineEnds) {
    EXPECT_EQ(find_control("a\tb\r\n\xC3\xA4"), std::string_view::npos);
    EXPECT_EQ(find_control("ab\x1b"), 2u);
    EXPECT_EQ(find_control(std::string_view("a\0", 2)), 1u);
    EXPECT_EQ(find_control("a\xff"), 1u);
}

TEST(Errors, ShowWhatTheyRepeatAndKeepItAsItIs) {
    const InvalidInput wrong("p.toml:1:1: \x1b]0;x", std::string(9'000'000, 'k'), "a\x07");
    EXPECT_EQ(wrong.what(), "p.toml:1:1: \\x1b]0;x: " + std::string(200, 'k') + "... (9000000 characters) (allowed: a\\x07)");
    EXPECT_EQ(wrong.value().size(), 9'000'000u);
    EXPECT_STREQ(IoError("\x1b.toml", "one\n\x1btwo").what(), "\\x1b.toml: one\n\\x1btwo");
}

TEST(Errors, SayHowManyMistakesAreLeftOut) {
    const std::string text = InvalidInputs(std::vector<InvalidInput>(203, InvalidInput("a", "b", "c"))).what();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 201);
    EXPECT_TRUE(text.ends_with("\nand 3 more"));
}

}  // namespace
}  // namespace fusee::core
