#include "fusee/core/change.h"

#include <gtest/gtest.h>

// Known: the sentences of suggestions, and what they ask to be changed.
namespace fusee::core {
namespace {

std::string shown(const std::vector<Changes>& alternatives) {
    std::string text;
    for (const Changes& changes : alternatives) {
        text += text.empty() ? "" : " | ";
        for (std::size_t i = 0; i < changes.size(); ++i) text += (i > 0 ? " & " : "") + changes[i].key + "=" + changes[i].value;
    }
    return text;
}

TEST(Suggestion, IsEmptyWithoutAlternatives) {
    EXPECT_TRUE(Suggestion().empty());
    EXPECT_TRUE(Suggestion("").empty()) << "no words are no advice";
    EXPECT_EQ(Suggestion().text(), "");
    EXPECT_TRUE(Suggestion().changes().empty());
}

TEST(Suggestion, OfWordsHasNoChange) {
    const Suggestion words = "a guide rod of 12 mm, or a chamfer there";
    EXPECT_FALSE(words.empty());
    EXPECT_TRUE(words.changes().empty());
    EXPECT_EQ(words.text(), "a guide rod of 12 mm, or a chamfer there");
}

TEST(Suggestion, HasAlternativesOfChangesThatAreMadeTogether) {
    const Suggestion both =
        change("k_pe.hub.bore_mm", "5.2")
            .or_else(change("k_pe.spring.rate_N_per_m", "9e+03").with("k_pe.spring.preload_mm", "4.1").noted(" (every arm x 0.9)"));
    EXPECT_EQ(both.text(),
              "k_pe.hub.bore_mm = 5.2, or k_pe.spring.rate_N_per_m = 9e+03 with k_pe.spring.preload_mm = 4.1 (every arm x 0.9)");
    EXPECT_EQ(shown(both.changes()), "k_pe.hub.bore_mm=5.2 | k_pe.spring.rate_N_per_m=9e+03 & k_pe.spring.preload_mm=4.1");
}

TEST(Suggestion, HasWordsAroundItsChanges) {
    const Suggestion mixed = change("k_se.path.kind", quoted("helix"))
                                 .begun("more turns: ")
                                 .noted(" with a land")
                                 .or_else("another spring")
                                 .or_else(change("law.end_torque_Nm", number(1.9)));
    EXPECT_EQ(mixed.text(), "more turns: k_se.path.kind = \"helix\" with a land, or another spring, or law.end_torque_Nm = 1.9");
    EXPECT_EQ(shown(mixed.changes()), "k_se.path.kind=\"helix\" | law.end_torque_Nm=1.9") << "words alone are no change";
    EXPECT_EQ(mixed.alternatives().size(), 3u);
}

TEST(Suggestion, GivesProgramsNoValueThatIsNotFinite) {
    const Suggestion endless = change("a.b", number(1.0 / 0.0)).or_else(change("a.c", "[1, nan]")).or_else(change("a.d", "2"));
    EXPECT_EQ(shown(endless.changes()), "a.d=2");
}

TEST(Suggestion, CanBeAddedToItself) {
    Suggestion twice = change("a.b", "1");
    EXPECT_EQ(twice.or_else(twice).text(), "a.b = 1, or a.b = 1");
}

TEST(Suggestion, NamesTheTableOfItsKeys) {
    const Suggestion pitch = change("path.kind", quoted("helix")).with("path.pitch_mm", "5").or_else("less wrap");
    EXPECT_EQ(pitch.of_table("k_pe").text(), "k_pe.path.kind = \"helix\" with k_pe.path.pitch_mm = 5, or less wrap");
}

TEST(Suggestion, WritesNumbersAndTextsAsToml) {
    EXPECT_EQ(number(2.0 / 3.0, 3), "0.667");
    EXPECT_EQ(number(9000.0, 1), "9e+03");
    EXPECT_EQ(number(60.0), "60");
    EXPECT_EQ(quoted("point"), "\"point\"");
}

}  // namespace
}  // namespace fusee::core
