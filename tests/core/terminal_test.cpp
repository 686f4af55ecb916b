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
