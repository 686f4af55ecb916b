#include "fusee/core/toml.h"

#include <gtest/gtest.h>

#include "fusee/core/error.h"

namespace fusee::core {
namespace {

std::string toml_refusal(const std::string& toml) {
    try {
        (void)parse_toml(toml, "t.toml");
    } catch (const IoError& e) {
        return e.what();
    }
    return "none";
}

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

TEST(Toml, DepthIsBounded) {
    const std::string dots = "t.toml:2:64: not valid TOML for fusee: more than 32 names in a dotted key";
    EXPECT_EQ(toml_refusal("x = 1\n" + repeated("a.", 31'000) + "a = 1\n"), dots);
    EXPECT_EQ(toml_refusal("x = 1\n" + repeated("a.", 31) + "a = 1\n"), "none");
    EXPECT_NE(toml_refusal("[" + repeated("a.", 31'000) + "a]\n").find("more than 32 names"), std::string::npos);
    EXPECT_NE(toml_refusal(repeated("\"a\" . ", 31'000) + "a = 1\n").find("more than 32 names"), std::string::npos);
    EXPECT_EQ(toml_refusal("x = " + repeated("[", 33)), "t.toml:1:37: not valid TOML for fusee: more than 32 nested brackets");
    EXPECT_EQ(toml_refusal("x = " + repeated("{a = ", 33)), "t.toml:1:165: not valid TOML for fusee: more than 32 nested brackets");
    EXPECT_EQ(toml_refusal("x = " + repeated("[", 32) + repeated("]", 32) + "\n"), "none");
}

TEST(Toml, DotsOfNumbersAndTextsAreNoDepth) {
    EXPECT_EQ(toml_refusal("x = [" + repeated("1.5, ", 1000) + "]\ny = \"" + repeated(".[", 1000) + "\"\n#" + repeated(".[", 1000)),
              "none");
    EXPECT_EQ(toml_refusal(repeated("[[a.b]]\nc = {d = 1.0}\n", 100)), "none");
}

TEST(Toml, NumbersThatNoDoubleHoldsAreRefusedWithTheirPlace) {
    EXPECT_EQ(toml_refusal("x = 1\ny = 1e400\n").rfind("t.toml:2:", 0), 0u) << toml_refusal("y = 1e400\n");
    EXPECT_EQ(toml_refusal("x = 99999999999999999999\n").rfind("t.toml:1:", 0), 0u);
}

TEST(Toml, CommonMistakesAreAnsweredWithWhatToWrite) {
    const auto expect_end = [](const std::string& toml, const std::string& end) {
        const std::string refusal = toml_refusal(toml);
        EXPECT_TRUE(refusal.ends_with(end)) << toml << ": " << refusal;
    };
    expect_end("a = 1\nx_mm = 0,8  # mm\n", "; a number has a decimal point: 0.8");
    expect_end("x_mm = 0.8 mm\n", "; a unit stands in the name of its key, not behind the number");
    expect_end("x_mm = 3mm\n", "; a unit stands in the name of its key, not behind the number");
    expect_end("name: \"x\"\n", "; write KEY = VALUE");
    expect_end("name = pnrvsa\n", "; a text stands in quotation marks");
    expect_end("name = \"x\ny = 1\n", "; a text ends with a quotation mark");
    expect_end("x = [1, 2\ny = 3\n", "'y'");
    expect_end("x = 1 = 2\n", "'='");
}

TEST(Toml, TextsHoldNoControlCharacters) {
    EXPECT_EQ(toml_refusal("a = 1\n[b]\nc = [\"x\", \"y\\u001b[2J\"]\n"),
              "t.toml:3:11: a text with the control character \\x1b at byte 2; tab and line end are allowed");
    EXPECT_NE(toml_refusal("a = \"tau\\u0000\"\n").find("\\x00 at byte 4"), std::string::npos);
    EXPECT_NE(toml_refusal("a = \"\\u009b\"\n").find("\\x9b at byte 1"), std::string::npos);
    EXPECT_EQ(toml_refusal("a = \"\\t\\n\"\nb = '''x\ny'''\nc = \"\xC3\xA4\"\n"), "none");
}

TEST(Toml, MessagesShowWhatTheyRepeat) {
    EXPECT_EQ(toml_refusal("a = \x1b\n").find('\x1b'), std::string::npos);
    EXPECT_EQ(toml_refusal("\"\\u001b\" = 1\n\"\\u001b\" = 2\n").find('\x1b'), std::string::npos);
    EXPECT_LT(toml_refusal("a = " + std::string(100'000, 'x')).size(), 6000u);
}

}  // namespace
}  // namespace fusee::core
