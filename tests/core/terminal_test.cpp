#include "fusee/core/terminal.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

namespace fusee::core {
namespace {

TEST(Terminal, LinesBreakAtSpacesAndHang) {
    EXPECT_EQ(wrapped("aa bb cc", 5), "aa bb\ncc");
    EXPECT_EQ(wrapped("aa bb cc", 7, 2, 1), "  aa bb\n   cc");
    EXPECT_EQ(wrapped("longword b", 4), "longword\nb") << "a long word stays whole";
    EXPECT_EQ(wrapped("\xC3\xA4\xC3\xA4 \xC3\xB6\xC3\xB6", 5), "\xC3\xA4\xC3\xA4 \xC3\xB6\xC3\xB6") << "letters count, not bytes";
    EXPECT_EQ(wrapped("", 10), "");
}

TEST(Terminal, LongLinesHangBelowTheirSecondColumn) {
    EXPECT_EQ(fitted("short\n  as it is\n", 12), "short\n  as it is\n");
    EXPECT_EQ(fitted("  9 deg  band at the joint", 20), "  9 deg  band at the\n         joint");
    EXPECT_EQ(fitted("  warning: a limit is broken", 15), "  warning: a\n    limit is\n    broken");
    EXPECT_EQ(fitted("  --least X the least value of all", 24, 12), "  --least X the least\n            value of all");
    EXPECT_EQ(fitted("   a verylongword b", 8), "   a\n     verylongword\n     b") << "a long word stays whole";
    EXPECT_EQ(fitted("  fusee make a.toml --out b", 10), "  fusee make a.toml --out b") << "a command is copied";
    EXPECT_EQ(fitted("1\t2 3 4 5", 4), "1\t2 3 4 5") << "a table for another program";
    EXPECT_EQ(cut("\xC3\xA4\xC3\xB6", 1), "\xC3\xA4");
}

TEST(Terminal, ColumnsStandInTheEnvironment) {
    ::setenv("COLUMNS", "57", 1);
    EXPECT_EQ(terminal_columns(), 57u);
    ::setenv("COLUMNS", "3", 1);
    EXPECT_EQ(terminal_columns(), 40u);
    ::unsetenv("COLUMNS");
}

TEST(Terminal, OnlySeverityAtTheBeginningOfALineIsColoured) {
    EXPECT_EQ(coloured("no error: here\n"), "no error: here\n");
    EXPECT_EQ(coloured("errors: 3"), "errors: 3");
    EXPECT_EQ(coloured("a\n  warning: b\nc"), "a\n  \x1b[1;33mwarning\x1b[0m: b\nc");
    EXPECT_EQ(coloured("error: x"), "\x1b[1;31merror\x1b[0m: x");
    EXPECT_EQ(coloured(""), "");
}

TEST(Terminal, ColourIsAskedForOrFollowsTheFile) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    EXPECT_FALSE(is_coloured(Colour::kAuto, ends[1]));
    EXPECT_TRUE(is_coloured(Colour::kAlways, ends[1]));
    EXPECT_FALSE(is_coloured(Colour::kNever, ends[1]));
    ::close(ends[0]);
    ::close(ends[1]);
}

}  // namespace
}  // namespace fusee::core
