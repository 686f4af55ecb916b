#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/fixture.h"

namespace fusee::report {
namespace {

constexpr double kNoWidth = std::numeric_limits<double>::quiet_NaN();

AsExported exported() {
    AsExported e{{0.4, 0.8, 1.2}, {1.0, 0.5, kNoWidth}, {}};
    e.joints.push_back({"assimp", {"k_se.stl", 1e-4, 2e-4}, {"k_pe.stl", 3e-4, 5e-4}, {1.001, 0.4999, kNoWidth}, true, ""});
    e.joints.push_back({"dxflib", {"k_se.dxf", 1e-5, 2e-5}, {}, {1.0, 0.5, kNoWidth}, true, ""});
    e.joints.push_back({"perimeters", {"k_se.gcode", 0.02, 0.03}, {}, {1.5, 0.9, kNoWidth}, false, ""});
    return e;
}

TEST(AsExportedReport, JsonHoldsNominalAndAsExportedSideBySide) {
    Fixture fixture;
    fixture.design.as_exported = exported();
    const auto json = nlohmann::json::parse(report_json(fixture.design))["as_exported"];
    EXPECT_EQ(json["tau_Nm"], nlohmann::json({0.4, 0.8, 1.2}));
    EXPECT_EQ(json["nominal_dead_band_rad"], nlohmann::json({1.0, 0.5, nullptr}));
    ASSERT_EQ(json["joints"].size(), 3u);
    EXPECT_EQ(json["joints"][0]["k_pe"]["file"], "k_pe.stl");
    EXPECT_EQ(json["joints"][0]["k_pe"]["worst_law_relative"], 5e-4);
    EXPECT_EQ(json["joints"][0]["dead_band_rad"], nlohmann::json({1.001, 0.4999, nullptr}));
    EXPECT_TRUE(json["joints"][1]["k_pe"]["file"].is_null());
    EXPECT_EQ(json["joints"][2]["binding"], false);
}

TEST(AsExportedReport, WorstChangeLeavesOutPrintsAndWhatTheLawDoesNotReach) {
    AsExported e = exported();
    EXPECT_NEAR(e.worst_change(), 1e-3, 1e-12);
    e.joints[0].dead_band[1] = kNoWidth;
    EXPECT_TRUE(std::isnan(e.worst_change())) << "a dead-band that a file has lost";
    e.joints.clear();
    EXPECT_TRUE(std::isnan(e.worst_change()));
}

// An inaccurate print is for a person to accept; an inaccurate file is an error.
TEST(AsExportedReport, AnInaccuratePrintIsAWarning) {
    Fixture fixture;
    fixture.design.parts[0].findings.clear();
    fixture.design.parts[1].findings.clear();
    fixture.design.findings.clear();
    EXPECT_EQ(verdict(fixture.design), core::Severity::kPass);
    readback::ArmError& error = fixture.design.parts[0].arm_errors[0];
    error.worst_relative = 0.02;
    EXPECT_EQ(verdict(fixture.design), core::Severity::kError);
    error.when_broken = core::Severity::kWarning;
    EXPECT_EQ(verdict(fixture.design), core::Severity::kWarning);
}

}  // namespace
}  // namespace fusee::report
