#include <gtest/gtest.h>

#include "page/bundle.h"
#include "page_structure.h"

namespace fusee::report {
namespace {

TEST(PageFile, NoTextOfAResultEndsItsElement) {
    const std::string json = R"({"name": "</script><b>&\u2028\u00e9 {title}", "figure": null, "share": 0.1})";
    const std::string page = page_file({"simulation", "a<b", "x < 1 & {style}", {{"result", json}}});
    expect_shell(page, "simulation", json, "x < 1 & {style}");
    EXPECT_EQ(occurrences(page, "</script"), occurrences(page, "<script"));
    expect_all(page, {"<title>a&lt;b", "\\u003c/script>\\u003cb>", "\\u2028", "\\u00e9 {title}"});
}

// nlohmann/json writes the same value without spaces and in ASCII.
TEST(PageFile, HoldsTheResultInAscii) {
    std::string text = "a\\\"b </x> \x7f \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80 \\";
    for (char c = 1; c < 0x20; ++c) text += c;
    const nlohmann::ordered_json value{{"text " + text, {1, -2.5e-7, 0.1, nullptr, true}}, {"list", {{"a", text}, {"b", {" ", "\\\\"}}}}};
    std::string expected = value.dump(-1, ' ', true);
    for (std::size_t at = expected.find('<'); at != std::string::npos; at = expected.find('<')) expected.replace(at, 1, "\\u003c");
    EXPECT_TRUE(holds(page_file({"score", "t", "s", {{"result", value.dump(2) + "\n"}}}), "\"result\">" + expected + "</script>"));
}

TEST(PageFile, OnlyAPageWithASceneCarriesItsScript) {
    const Page page{"design", "joint", "", {{"result", "{}"}, {"joint-scene", "[1]"}}, true};
    Page plain = page;
    plain.scene = false;
    EXPECT_EQ(data_of(page_file(page), "joint-scene")[0], 1);
    EXPECT_GT(page_file(page).size(), page_file(plain).size() + 100'000) << "three.js";
    EXPECT_EQ(page_file(page), page_file(page)) << "same input, same bytes";
}

}  // namespace
}  // namespace fusee::report
