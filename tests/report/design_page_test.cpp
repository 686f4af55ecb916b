#include <algorithm>

#include "design/parts.h"
#include "fusee/report/report.h"
#include "page_structure.h"
#include "report/fixture.h"

namespace fusee::report {
namespace {

using Line = std::vector<std::array<double, 2>>;

/// "x,y x,y ..."
Line line_of(const nlohmann::json& text) {
    std::istringstream in(text.get<std::string>());
    Line line;
    char comma = 0;
    for (std::array<double, 2> p{}; in >> p[0] >> comma >> p[1];) line.push_back(p);
    return line;
}

double width_of(const nlohmann::json& text) {
    const Line line = line_of(text);
    const auto [low, high] = std::minmax_element(line.begin(), line.end());
    return (*high)[0] - (*low)[0];
}

TEST(DesignPage, HoldsTheJsonAndTheSummary) {
    const Fixture fixture("<b>&\"");
    const std::string page = report_html(fixture.design), json = report_json(fixture.design);
    expect_shell(page, "design", json, "warning: cable.bend_ratio");
    EXPECT_EQ(page, report_html(Fixture("<b>&\"").design)) << "same input, same bytes";
    EXPECT_FALSE(holds(page, "<frays>"));
    expect_shell(report_html(DesignReport{}), "design", report_json(DesignReport{}), "");
}

TEST(DesignPage, TheJsonHoldsWhatThePageDraws) {
    const Fixture fixture;
    const nlohmann::json json = nlohmann::json::parse(report_json(fixture.design));
    EXPECT_EQ(json["made_by"], fixture.design.provenance.line());
    EXPECT_EQ(json["law"]["curves"]["f_se_Nm"].size(), 41u);
    const nlohmann::json& part = json["parts"][1];
    EXPECT_NEAR(part["arms"]["arm_mm"][0].get<double>(), kDiscRadius_mm, 1e-9);
    EXPECT_GT(part["arms"]["z_mm"].back().get<double>(), part["arms"]["z_mm"][0].get<double>()) << "a helix";
    EXPECT_EQ(part["read_back"][0]["severity"], "pass");
    EXPECT_TRUE(part["certificate"].contains("least_proven_mm"));
    EXPECT_FALSE(part["cam"].contains("roller"));
    EXPECT_TRUE(json["assembly"].is_null());
    EXPECT_EQ(json["no_assembly"], "");
}

TEST(DesignPage, SaysWhyThereIsNoAssembly) {
    Fixture fixture;
    core::Finding refusal = core::not_judged("joint.roller", "an assembly with a roller on the cam is not modelled", "k_pe.family");
    refusal.where = "k_pe";
    fixture.design.findings.push_back(refusal);
    EXPECT_EQ(nlohmann::json::parse(report_json(fixture.design))["no_assembly"],
              "k_pe: an assembly with a roller on the cam is not modelled.");
}

TEST(CamDrawing, ADiscOfRadius10mmIs20mmWide) {
    const nlohmann::json drawing = drawing_json(disc(cam::PartKind::kSeries));
    // Coordinates have three decimals, so two ends are off by at most 1e-3 together.
    EXPECT_NEAR(width_of(drawing["pitch"]), 20.0, 1e-3);
    EXPECT_NEAR(width_of(drawing["body"][0]), 20.0, 1e-3);
    EXPECT_NEAR(width_of(drawing["floor"]), 19.0, 1e-3);  // half a cable of 1 mm on each side
    EXPECT_EQ(drawing["around"], "");
}

TEST(CamDrawing, TheWorkingArcAndTheCableStandWhereTheyTouch) {
    const nlohmann::json drawing = drawing_json(disc(cam::PartKind::kSeries)), &end = drawing["ends"][0];
    EXPECT_NEAR(line_of(drawing["working"]).front()[0], 10.0 * std::cos(0.5), 1e-3);
    EXPECT_NEAR(end["contact_mm"][1].get<double>(), 10.0 * std::sin(0.5), 1e-3);
    EXPECT_NEAR(end["contact_mm"][0].get<double>() * end["direction"][0].get<double>() +
                    end["contact_mm"][1].get<double>() * end["direction"][1].get<double>(),
                0.0, 1e-9)
        << "the cable is a tangent";
}

}  // namespace
}  // namespace fusee::report
