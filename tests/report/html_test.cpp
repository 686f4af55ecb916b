#include "page/html.h"

#include "page_structure.h"
#include "report/fixture.h"

namespace fusee::report {
namespace {

core::Finding unjudged() { return core::not_judged("spring.stress", "the wire yielding", "k_se.spring.wire_mm"); }

TEST(ReportHtml, IsWellFormedAndLoadsNothing) {
    const Fixture fixture;
    const std::string html = report_html(fixture.design);
    expect_page(html);
    expect_page(report_html(Fixture("<b>&\"").design));
    EXPECT_TRUE(holds(report_html(Fixture("<b>&\"").design), "<h1>&lt;b&gt;&amp;&quot;</h1>"));
    EXPECT_FALSE(holds(html, "<frays>"));
    EXPECT_EQ(html, report_html(Fixture().design)) << "same input, same bytes";
}

TEST(ReportHtml, ShowsEveryFigureOfTheDesign) {
    const std::string html = report_html(Fixture().design);
    EXPECT_EQ(elements(html, "h2").size(), 8u) << "two parts, findings, passed, law, dead-band, read-back, files";
    EXPECT_EQ(occurrences(html, "<figure class=\"plot\""), 2u + 1u + 4u + 2u) << "arms, height of the helix, law, joint";
    expect_all(html, {"cable.bend_ratio", "preload 4.1 rad", "a handbook", ">6.1 mm<", "\u2265 8 mm", "assimp", "0.02 %", "springs.csv",
                      "51.1 kB", "via=cgal", "10.0000 mm", "not proven", "warning-tag"});
}

TEST(ReportHtml, RulesThatWereNotJudgedStandBetweenWarningsAndPasses) {
    Fixture fixture;
    fixture.design.parts[0].findings.push_back(unjudged());
    const std::string html = report_html(fixture.design);
    const auto warning = html.rfind("class=\"tag warning-tag\""), open = html.find("class=\"tag unjudged-tag\""),
               missing = html.find("k_se.spring.wire_mm"), passed = html.find("class=\"scroll dense\"");
    EXPECT_TRUE(warning < open && open < missing && missing < passed && passed != std::string::npos);
    EXPECT_TRUE(holds(elements(html, "header").front(), "0 errors, 2 warnings"));
    EXPECT_TRUE(holds(elements(html, "header").front(), "1 rule not judged: spring 1"));
    expect_page(html);
}

TEST(ReportHtml, TheVerdictHasTheClassOfTheWorstFinding) {
    DesignReport design;
    EXPECT_TRUE(holds(report_html(design), "verdict pass-tag"));
    design.findings = {unjudged()};
    EXPECT_TRUE(holds(report_html(design), "verdict unjudged-tag"));
    design.findings.push_back(finding("cable.bend_ratio", core::Severity::kError, 0.0));
    EXPECT_TRUE(holds(report_html(design), "verdict error-tag"));
}

TEST(ReportHtml, NumbersOnTheDrawingAreThoseOfTheTable) {
    const std::string html = report_html(Fixture().design);
    // The warnings of k_se and k_pe are 1 and 2, each marked on its own drawing.
    const auto spool = html.find("class=\"cam k_se\""), cam = html.find("class=\"cam k_pe\"");
    const auto first = html.find("<title>1. cable.bend_ratio"), second = html.find("<title>2. cable.bend_ratio");
    EXPECT_TRUE(spool < first && first < cam && cam < second && second != std::string::npos);
}

TEST(ReportHtml, AnEmptyDesignIsStillAPage) {
    expect_page(report_html(DesignReport{}));
    EXPECT_TRUE(elements(report_html(DesignReport{}), "section").empty());
}

TEST(Html, NumbersHaveAFixedNumberOfDigits) {
    EXPECT_EQ(number(std::numeric_limits<double>::quiet_NaN()), "\u2013");
    EXPECT_EQ(number(-INFINITY), "\u2013");
    EXPECT_EQ(number(1234.5678), "1235");
    EXPECT_EQ(number(40763.2), "40763");
    EXPECT_EQ(number(0.000123456), "0.0001235");
    EXPECT_EQ(span({NAN, 1.0}), "\u2013");
    EXPECT_EQ(span({0.12, 0.5}), "0.12 to 0.5");
    EXPECT_EQ(change(9.1, NAN), "9.1 \u2192 \u2013");
    EXPECT_EQ(percent(0.623), "62 %");
    EXPECT_EQ(percent(NAN), "\u2013");
    EXPECT_EQ(coordinate(-0.0001), "0");
    EXPECT_EQ(coordinate(1.25), "1.25");
    EXPECT_EQ(bytes_text(999), "999 B");
    EXPECT_EQ(bytes_text(51084), "51.1 kB");
    EXPECT_EQ(compared(core::rad_from_deg(20.0), core::rad_from_deg(21.5)).html, "20 (-1.5)");
    EXPECT_EQ(compared(NAN, 1.0).html, "\u2013");
}

TEST(Html, EveryBlockEscapesItsTexts) {
    const std::string evil = "<i>&";
    const Head head{evil, evil, verdict_tag(core::Severity::kPass, evil), evil, evil, {{evil, evil}}};
    const std::string html =
        html_page(evil, head,
                  section(evil, html_table(evil, {evil}, {{plain(evil), code(evil), num(evil), faint(evil), share_cell(0.5, evil)}}) +
                                    html_facts({{evil, evil}}) + paragraph(evil) + subheading(evil) + bullet_list({evil}) +
                                    tag(core::Severity::kError, evil)));
    EXPECT_FALSE(holds(html, "<i>"));
    EXPECT_EQ(occurrences(html, "&lt;i&gt;&amp;"), 24u) << "caption, label of the region, table of contents";
    expect_page(html);
}

}  // namespace
}  // namespace fusee::report
