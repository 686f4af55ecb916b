#include "page/html.h"

#include <gtest/gtest.h>

#include <regex>

#include "report/fixture.h"

namespace fusee::report {
namespace {

/// The first tag that does not close what was opened last; "" if all is balanced.
std::string first_unbalanced(const std::string& html) {
    static const std::regex kTag("<(/?)([a-zA-Z0-9]+)([^<>]*?)(/?)>");
    std::vector<std::string> open;
    for (auto it = std::sregex_iterator(html.begin(), html.end(), kTag); it != std::sregex_iterator(); ++it) {
        const std::string name = (*it)[2];
        if ((*it)[4].length() > 0 || name == "meta" || name == "br") continue;
        if ((*it)[1].length() == 0) {
            open.push_back(name);
        } else {
            if (open.empty() || open.back() != name) return (*it)[0];
            open.pop_back();
        }
    }
    return open.empty() ? "" : open.back();
}

std::string without_style(const std::string& html) {
    const auto begin = html.find("<style>"), end = html.find("</style>");
    return html.substr(0, begin) + html.substr(end + 8);
}

TEST(ReportHtml, IsWellFormedAndAsksForNothing) {
    const Fixture fixture;
    const std::string html = report_html(fixture.design);
    EXPECT_EQ(first_unbalanced(without_style(html)), "");
    for (const char* word : {"http://", "https://", "url(", "@import", "<script", "<link", "<img", "src="})
        EXPECT_EQ(html.find(word), std::string::npos) << word;
    EXPECT_EQ(html.find(">nan"), std::string::npos);
    EXPECT_EQ(html.find("inf "), std::string::npos);
    EXPECT_NE(html.find("10.0000 mm on all of the contour, convex: proven"), std::string::npos);
    EXPECT_NE(html.find("convex: not proven"), std::string::npos);
}

TEST(ReportHtml, ShowsEverySection) {
    const Fixture fixture;
    const std::string html = report_html(fixture.design);
    for (const char* word : {"Review and accept", "Spring law",       "What stiction leaves",
                             "k_se: spool",       "k_pe: cam",        "Height of the cable on the helix",
                             "Findings",          "cable.bend_ratio", "preload 4.1 rad",
                             "a handbook",        "6.1 mm",           "\u2265 8 mm",
                             "Read back",         "assimp",           "0.02 %",
                             "springs.csv",       "51.1 kB",          "lead-in",
                             "exact extremes",    "covered",          "via=cgal"})
        EXPECT_NE(html.find(word), std::string::npos) << word;
}

TEST(ReportHtml, WhatWasNotJudgedStandsBeforeThePasses) {
    Fixture fixture;
    fixture.design.parts[0].findings.push_back(core::not_judged("spring.stress", "the wire yielding", "k_se.spring.wire_mm"));
    const std::string html = report_html(fixture.design);
    EXPECT_NE(html.find("! Review and accept; 1 rule not judged<"), std::string::npos);
    EXPECT_NE(html.find("changes required / to review / not judged: spring 1"), std::string::npos);
    const auto block = html.find(">Not judged<"), missing = html.find("k_se.spring.wire_mm"), held = html.find("rules hold<");
    EXPECT_TRUE(block < missing && missing < held && held != std::string::npos);
    EXPECT_EQ(first_unbalanced(without_style(html)), "");
    DesignReport open;
    open.findings = {core::not_judged("spring.stress", "the wire yielding", "k_se.spring.wire_mm")};
    EXPECT_NE(report_html(open).find("Can be made; 1 rule not judged<"), std::string::npos);
}

TEST(ReportHtml, NumbersOnTheDrawingAreThoseOfTheTable) {
    const Fixture fixture;
    const std::string html = report_html(fixture.design);
    // The gravest come first: the reviews of k_se and k_pe are 1 and 2, each marked on its own drawing.
    const auto spool = html.find("class=\"cam k_se\""), cam = html.find("class=\"cam k_pe\"");
    const auto first = html.find("<title>1. cable.bend_ratio"), second = html.find("<title>2. cable.bend_ratio");
    EXPECT_TRUE(spool < first && first < cam && cam < second && second != std::string::npos);
}

TEST(ReportHtml, TextsCannotBecomeMarkup) {
    const Fixture fixture("<b>&\"");
    const std::string html = report_html(fixture.design);
    EXPECT_EQ(html.find("<b>&\""), std::string::npos);
    EXPECT_NE(html.find("<h1>&lt;b&gt;&amp;&quot;</h1>"), std::string::npos);
    EXPECT_EQ(html.find("<frays>"), std::string::npos);
    EXPECT_EQ(first_unbalanced(without_style(html)), "");
}

TEST(ReportHtml, AnEmptyDesignIsStillAPage) {
    const std::string html = report_html(DesignReport{});
    EXPECT_EQ(first_unbalanced(without_style(html)), "");
    EXPECT_EQ(html.find("<section>"), std::string::npos);
}

TEST(ReportHtml, SameInputSameBytes) {
    const Fixture a, b;
    EXPECT_EQ(report_html(a.design), report_html(b.design));
    EXPECT_EQ(report_json(a.design), report_json(b.design));
}

TEST(Html, NumbersAndSizes) {
    EXPECT_EQ(number(std::numeric_limits<double>::quiet_NaN()), "\u2013");
    EXPECT_EQ(number(1234.5678), "1235");
    EXPECT_EQ(number(40763.2), "40763");
    EXPECT_EQ(number(0.000123456), "0.0001235");
    EXPECT_EQ(coordinate(-0.0001), "0");
    EXPECT_EQ(coordinate(1.25), "1.25");
    EXPECT_EQ(bytes_text(999), "999 B");
    EXPECT_EQ(bytes_text(51084), "51.1 kB");
}

}  // namespace
}  // namespace fusee::report
