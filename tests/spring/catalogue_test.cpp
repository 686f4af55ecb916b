#include "fusee/spring/catalogue.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "fusee/core/error.h"
#include "refused.h"

namespace fusee::spring {
namespace {

const std::string kHeader = "kind,name,rate,wire_mm,coil_mm,active_coils,free_length_mm,max_deflection,max_load,tensile_strength_MPa\n";
const std::string kStiff = "compression,D2,7500,1.8,14,8,50,25,180,1900\n", kSoft = "compression,D1,5000,1.6,14,8,55,28,140,1950\n",
                  kTorsionRow = "torsion,T1,0.02,0.8,10,30,0,12,0.3,2100\n";

std::string field_of(const std::string& rows) {
    return field_refused([&] { return parse_catalogue(kHeader + rows, "springs.csv"); });
}

TEST(Catalogue, SpringsComeInSiAndByRisingRate) {
    const Catalogue c = parse_catalogue(kHeader + kStiff + kTorsionRow + kSoft, "springs.csv");
    ASSERT_EQ(c.compression.size(), 2u);
    ASSERT_EQ(c.torsion.size(), 1u);
    EXPECT_EQ(c.of(BaseKind::kCompression).front().name, "D1");
    const BaseSpring& stiff = c.compression.back().spring;
    EXPECT_EQ(stiff.rate, 7500.0);
    EXPECT_DOUBLE_EQ(stiff.wire_diameter, 1.8e-3);
    EXPECT_DOUBLE_EQ(stiff.max_state, 25e-3);
    EXPECT_EQ(stiff.max_load, 180.0);
    EXPECT_DOUBLE_EQ(stiff.tensile_strength, 1900e6);
    EXPECT_EQ(stiff.stress_share, 0.0) << "that of its kind";
    EXPECT_EQ(c.torsion.front().spring.max_state, 12.0);  // rad, as written
    EXPECT_EQ(c.torsion.front().spring.preload, 0.0);
}

TEST(Catalogue, MistakesNameTheirCell) {
    EXPECT_EQ(field_of("extension,D1,5000,1.6,14,8,55,28,140,1950\n"), "springs.csv:2:1: kind");
    EXPECT_EQ(field_of(kSoft + kSoft), "springs.csv:3:13: name");
    EXPECT_EQ(field_of("compression,D1,0,1.6,14,8,55,28,140,1950\n"), "springs.csv:2:16: rate");
    EXPECT_EQ(field_of("compression,D1,5000,1.6,1.5,8,55,28,140,1950\n"), "springs.csv:2:25: coil_mm");
    EXPECT_EQ(field_of("compression,D1,5000,1.6,14,8,0,28,140,1950\n"), "springs.csv:2:30: free_length_mm");
    EXPECT_EQ(field_of("compression,D1,5000,1.6,14,8,55,x,140,1950\n"), "springs.csv:2:33: max_deflection");
}

// A vendor's list of one kind: newtons per millimetre in the header.
TEST(Catalogue, UnitsInTheHeaderAreConverted) {
    std::string header = kHeader;
    header.replace(header.find("rate"), 4, "Rate [N/mm]").replace(header.find("max_deflection"), 14, "max_deflection (mm)");
    const Catalogue c = parse_catalogue(header + "compression,D1,3,1.6,14,8,55,28,84,1950\n", "springs.csv");
    EXPECT_DOUBLE_EQ(c.compression.front().spring.rate, 3000.0);
    EXPECT_DOUBLE_EQ(c.compression.front().spring.max_state, 28e-3);
    EXPECT_EQ(field_refused([&] { return parse_catalogue(header + kTorsionRow, "springs.csv"); }), "springs.csv:2:12: Rate [N/mm]");
}

TEST(Catalogue, FiguresThatLookLikeAnotherUnitAreAskedAbout) {
    const auto said = [](const std::string& rows) -> std::string {
        try {
            (void)parse_catalogue(kHeader + rows, "springs.csv");
        } catch (const core::InputError& e) {
            return e.what();
        }
        return "none";
    };
    EXPECT_NE(said("compression,D1,3,1.6,14,8,55,28,84,1950\n").find("'rate=rate in N/mm'"), std::string::npos);
    EXPECT_NE(said("compression,D1,3000,1.6,14,8,55,0.028,84,1950\n").find("'max_deflection=max_deflection in m'"), std::string::npos);
    EXPECT_NE(said("torsion,T1,0.0000767,0.8,10,30,0,700,0.3,2100\n").find("are these Nm/deg"), std::string::npos);
    EXPECT_NE(said("torsion,T1,0.02,0.8,10,30,0,687,0.24,2100\n").find("are these degrees"), std::string::npos);
    EXPECT_NE(said("torsion,T1,0.02,0.8,10,30,0,12,240,2100\n").find("are these mNm"), std::string::npos);
    EXPECT_EQ(
        parse_catalogue(kHeader + "compression,D1,3,1.6,14,8,55,28,84,1950\n", "springs.csv", core::CsvMapping::of({"rate=rate in N/mm"}))
            .compression.front()
            .spring.rate,
        3000.0);
    EXPECT_EQ(said(kTorsionRow + kStiff + kSoft), "none");
}

TEST(Catalogue, TheOneThatComesWithFuseeCanBeRead) {
    const Catalogue c = read_catalogue(std::filesystem::path(FUSEE_SOURCE_DIR) / "profiles/springs/catalogue.csv");
    EXPECT_GE(c.torsion.size(), 20u);
    EXPECT_GE(c.compression.size(), 20u);
}

}  // namespace
}  // namespace fusee::spring
