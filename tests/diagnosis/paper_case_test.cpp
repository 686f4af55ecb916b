#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

#include "fusee/gap_case/case.h"
#include "fusee/spring/laws.h"

// The paper's dead-band tables as gap cases, as they ship. Their diagnoses, which neither name a cause nor acquit the model, are compared
// with docs/paper-case-study.md.
namespace fusee::diagnosis {
namespace {

gap_case::Case shipped_case(const std::string& name) {
    return gap_case::read_case(std::filesystem::path(FUSEE_SOURCE_DIR) / "profiles" / "gap" / name);
}

struct PaperTable {
    const char* name;
    std::size_t rows;
    double first_deg, last_deg;  ///< as printed
};
void PrintTo(const PaperTable& table, std::ostream* out) { *out << table.name; }

class PaperTables : public testing::TestWithParam<PaperTable> {};

TEST_P(PaperTables, AreThePrintedWidths) {
    const gap_case::Case gap_case = shipped_case(GetParam().name);
    ASSERT_EQ(gap_case.rows.dead_band.size(), GetParam().rows);
    EXPECT_TRUE(gap_case.rows.dead_band_width_only);
    const double degree = std::numbers::pi / 180.0, printed = 1e-5;  // rad: the files have five decimals
    EXPECT_NEAR(gap_case.rows.dead_band.front().width, GetParam().first_deg * degree, printed);
    EXPECT_NEAR(gap_case.rows.dead_band.back().width, GetParam().last_deg * degree, printed);
}

TEST(PaperCases, SpringsOfTable2AreThoseOfTheNewSprings) {
    const gap_case::NominalRig rig = shipped_case("paper_table_2").rig;
    const auto law = spring::make_stiction_law(
        {.k = 0.353, .u = 0.015, .c = 0.0455, .mu = rig.gear_load_friction, .start_torque = 0.09, .end_torque = 2.5});
    ASSERT_TRUE(law);
    const double start = 3.6, printed = 1e-5;  // rad below which no law is; shares of a row's six digits
    std::size_t seen = 0;
    for (const gap_case::NominalRig::SpringRow& row : rig.springs) {
        if (row.deflection < start) continue;
        const spring::LawPoint point = (*law)->at_load(row.se_torque + row.pe_torque);
        EXPECT_NEAR(row.deflection, start + point.theta, printed * row.deflection);
        EXPECT_NEAR(row.se_torque, point.f_se, printed);
        ++seen;
    }
    EXPECT_GT(seen, 50U);
}

INSTANTIATE_TEST_SUITE_P(Published, PaperTables,
                         testing::Values(PaperTable{"paper_table_1", 4, 3.5, 85.5}, PaperTable{"paper_table_2", 5, 104.61, 49.81}),
                         [](const auto& table) { return std::string(table.param.name); });

}  // namespace
}  // namespace fusee::diagnosis
