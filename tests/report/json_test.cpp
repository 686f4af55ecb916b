#include <nlohmann/json.hpp>

#include "page_structure.h"
#include "report/fixture.h"

namespace fusee::report {
namespace {

TEST(ReportJson, HoldsWhatItDocuments) {
    const Fixture fixture;
    const auto j = nlohmann::json::parse(report_json(fixture.design));
    EXPECT_EQ(j["name"], "disc");
    EXPECT_EQ(j["fusee"], core::version());
    EXPECT_EQ(j["verdict"], core::to_string(core::Severity::kWarning));
    EXPECT_EQ(j["law"]["loads_Nm"], (std::vector<double>{0.3, 1.3}));
    EXPECT_EQ(j["law"]["covers_stiction"], true);
    EXPECT_TRUE(j["law"]["least_feasible_start_Nm"].is_null());
    EXPECT_EQ(j["dead_band"].size(), 5u);
    EXPECT_EQ(j["dead_band"][0]["linear_rad"], 1.0 / 0.4);
    EXPECT_TRUE(j["dead_band"][4]["exact_rad"].is_null());
    ASSERT_EQ(j["parts"].size(), 2u);
    const auto& spool = j["parts"][0];
    EXPECT_EQ(spool["part"], "k_se");
    EXPECT_EQ(spool["spring"]["kind"], "torsion");
    EXPECT_EQ(spool["spring"]["states_rad"], (std::vector<double>{3.0, 5.0}));
    EXPECT_EQ(spool["cam"]["tensions_N"], (std::vector<double>{5.0, 9.0}));
    EXPECT_EQ(spool["cam"]["travel_rad"], 2.0);
    EXPECT_EQ(spool["certificate"]["convex"], "proven");
    EXPECT_EQ(spool["certificate"]["working_arc"]["proven_mm"], 10.0);
    EXPECT_TRUE(spool["certificate"]["floor_in_space"].is_null());
    EXPECT_EQ(spool["certificate"]["boxes"], 2);
    EXPECT_FALSE(spool["certificate"]["assumed"].empty());
    EXPECT_EQ(j["parts"][1]["certificate"]["convex"], "not proven");
    EXPECT_EQ(spool["mesh"]["triangles"], fixture.spool.mesh.triangles.size());
    EXPECT_EQ(spool["files"][0]["bytes"], 51084);
    EXPECT_EQ(spool["read_back"][0]["passed"], true);
    EXPECT_EQ(spool["findings"][1]["severity"], core::to_string(core::Severity::kWarning));
    EXPECT_EQ(spool["findings"][1]["place"]["point_mm"].size(), 3u);
    EXPECT_EQ(j["parts"][1]["cam"]["path"], "helix");
    EXPECT_EQ(j["parts"][1]["cam"]["family"], "cable");
    EXPECT_EQ(j["files"][0]["name"], "springs.csv");
}

TEST(ReportJson, CountsWhatWasNotJudgedAndGivesItNoNumbers) {
    Fixture fixture;
    fixture.design.parts[0].findings.push_back(core::not_judged("spring.stress", "the wire yielding", "k_se.spring.wire_mm"));
    const auto j = nlohmann::json::parse(report_json(fixture.design));
    EXPECT_EQ(j["rules"]["not_judged"], 1);
    EXPECT_EQ(j["rules"]["passed"], 3);
    EXPECT_EQ(j["rules"]["groups"]["spring"]["not_judged"], 1);
    EXPECT_EQ(j["rules"]["groups"]["cable"]["warnings"], 2);
    const auto& open = j["parts"][0]["findings"][2];
    EXPECT_EQ(open["severity"], "not judged");
    EXPECT_TRUE(open["measured"].is_null());
    EXPECT_TRUE(open["allowed"].is_null());
    EXPECT_EQ(open["suggestion"], "k_se.spring.wire_mm");
    EXPECT_TRUE(open["changes"].empty());
}

// Known: residuals 0, +2 and -1 mNm: rms sqrt(5/3).
TEST(ReportJson, ATableHasItsRowsAndResiduals) {
    Fixture fixture;
    fixture.design.law.table =
        SmoothedTable{"pulled.csv", {{0.0, 0.1, 0.2, 0.1, 0.2}, {0.1, 0.11, 0.21, 0.112, 0.21}, {0.2, 0.12, 0.22, 0.119, 0.22}}};
    const auto j = nlohmann::json::parse(report_json(fixture.design))["law"]["table"];
    EXPECT_EQ(j["file"], "pulled.csv");
    EXPECT_EQ(j["rows"].size(), 3u);
    EXPECT_EQ(j["rows"][1], (std::vector<double>{0.1, 0.11, 0.112, 0.21, 0.21}));
    EXPECT_NEAR(j["series"]["rms_Nm"].get<double>(), 1e-3 * std::sqrt(5.0 / 3.0), 1e-9);
    EXPECT_NEAR(j["series"]["largest_Nm"].get<double>(), 2e-3, 1e-12);
    EXPECT_EQ(j["series"]["largest_in_row"], 2);
    EXPECT_EQ(j["parallel"]["rms_Nm"], 0.0);
}

TEST(ReportJson, RenamedFieldsKeepTheirOldSpelling) {
    const auto j = nlohmann::json::parse(report_json(Fixture().design));
    EXPECT_EQ(j["outlook"], j["headline"]);
    EXPECT_EQ(j["rules"]["review"], j["rules"]["warnings"]);
    EXPECT_EQ(j["rules"]["groups"]["cable"]["required"], 0);
    EXPECT_EQ(j["renamed_fields"]["outlook"], "headline");
}

TEST(ReportJson, TextsThatAreNoUtf8DoNotLoseTheReport) {
    const Fixture fixture("bad\xFF");
    const auto j = nlohmann::json::parse(report_json(fixture.design));
    EXPECT_EQ(j["name"], "bad\uFFFD");
}

TEST(ReportJson, NamesTheFamilyOfACam) {
    Fixture fixture;
    fixture.spool.cam.options.family = cam::Family::kRoller;
    EXPECT_EQ(nlohmann::json::parse(report_json(fixture.design))["parts"][0]["cam"]["family"], "roller");
}

TEST(Verdict, IsTheWorstOfAllFindingsAndReadings) {
    Fixture fixture;
    EXPECT_EQ(verdict(fixture.design), core::Severity::kWarning);
    fixture.design.parts[1].arm_errors[0].worst_relative = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(verdict(fixture.design), core::Severity::kError);
    EXPECT_EQ(verdict(DesignReport{}), core::Severity::kPass);
    DesignReport open;
    open.findings = {core::not_judged("spring.stress", "the wire yielding", "k_se.spring.wire_mm")};
    EXPECT_EQ(verdict(open), core::Severity::kNotJudged);
}

TEST(LawReport, CoversStictionOnlyAtBothEnds) {
    Fixture fixture;
    LawReport& law = fixture.design.law;
    EXPECT_TRUE(law.covers_stiction());
    law.stiction_loads = {0.3, 1.3};
    EXPECT_TRUE(law.covers_stiction());
    law.stiction_loads = {0.3, 1.31};
    EXPECT_FALSE(law.covers_stiction());
    law.stiction_loads = {0.29, 1.3};
    EXPECT_FALSE(law.covers_stiction());
}

}  // namespace
}  // namespace fusee::report
