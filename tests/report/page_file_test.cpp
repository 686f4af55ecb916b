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
