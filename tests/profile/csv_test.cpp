#include <sstream>

#include "fusee/core/units.h"
#include "profile/fixture.h"

namespace fusee::profile {
namespace {

constexpr const char* kHeader = "angle_rad,series_Nm,parallel_Nm\n";
constexpr const char* kRows = "0,0.1,0.2\n0.5,0.2,0.3\n1.0,0.3,0.4\n1.5,0.4,0.5\n2,0.5,0.6\n2.5,0.6,0.7\n3,0.7,0.8\n3.5,0.8,0.9\n";

class CsvTest : public ProfileTest {
protected:
    TablePair table(const std::string& csv) const {
        core::write_file(folder_ / "t.csv", csv);
        return std::get<TablePair>(read(toml()).law.curves);
    }
    std::string refusal_of(const std::string& csv) const {
        core::write_file(folder_ / "t.csv", csv);
        return refusal(toml());
    }
    static std::string toml() {
        return edited("kind = \"stiction_compensating\"\nk_per_Nm_rad = 0.225\nu_Nm = 0.0012\nc_Nm = 0.265\n",
                      "kind = \"table\"\nfile = \"t.csv\"\n");
    }
};

TEST_F(CsvTest, ReadsRowsCommentsSpacesAndForeignLineEnds) {
    const TablePair t = table(std::string("\xEF\xBB\xBF# bench 3\r\n angle_rad, series_Nm ,parallel_Nm\r\n\r\n 0 , +1e-1,0.2\r\n") +
                              std::string(kRows).substr(10));
    EXPECT_EQ(t.angle.size(), 8u);
    EXPECT_EQ(t.series.front(), 0.1);
    EXPECT_EQ(t.parallel.back(), 0.9);
}

TEST_F(CsvTest, ColumnsOfTheProfileAreReadAndWritten) {
    core::write_file(folder_ / "t.csv", "Winkel;series_Nm;parallel_mNm\n" + std::string("0;0,1;200\n1;0,2;300\n2;0,3;400\n3;0,4;500\n") +
                                            "4;0,5;600\n5;0,6;700\n6;0,7;800\n7;0,8;900\n");
    const Profile p = read(toml() + "[columns]\nangle_rad = \"Winkel in deg\"\n");
    const TablePair& t = std::get<TablePair>(p.law.curves);
    EXPECT_DOUBLE_EQ(t.angle.back(), core::rad_from_deg(7.0));
    EXPECT_EQ(t.parallel.back(), 0.9);
    const std::string written = to_toml(p);
    EXPECT_NE(written.find("[columns]\nangle_rad = \"Winkel in deg\"\n"), std::string::npos) << written;
    EXPECT_EQ(std::get<TablePair>(parse_profile(written, p.file).law.curves).angle, t.angle);
}

TEST_F(CsvTest, LastLineNeedsNoLineEnd) {
    const std::string rows = kRows;
    EXPECT_EQ(table(kHeader + rows.substr(0, rows.size() - 1)).parallel.back(), 0.9);
}

TEST_F(CsvTest, FallingAnglesAreTheSameLaw) {
    std::string falling;
    std::istringstream lines(kRows);
    for (std::string line; std::getline(lines, line);) falling.insert(0, line + "\n");
    const TablePair down = table(kHeader + falling), up = table(kHeader + std::string(kRows));
    EXPECT_EQ(down.angle, up.angle);
    EXPECT_EQ(down.series, up.series);
    EXPECT_EQ(down.parallel, up.parallel);
}

TEST_F(CsvTest, ThreePointsOfOneSpringAreSentToAnotherKind) {
    core::write_file(folder_ / "t.csv", "angle [deg],torque [in-lb]\n0,1\n45,2\n90,4\n");
    const auto refusal = [&] {
        try {
            (void)read("name = \"one\"\nkind = \"spring\"\n[law]\nkind = \"table\"\nfile = \"t.csv\"\n[cam]\nfamily = \"cable\"\n");
        } catch (const core::InputError& e) {
            return std::string(e.what());
        }
        return std::string();
    }();
    expect_words(refusal, {"t.csv: 3 rows", "at least 8", "law.kind = \"points\"", "\"polynomial\""});
    EXPECT_EQ(refusal.find("in-lb"), std::string::npos) << refusal;
}

TEST_F(CsvTest, RefusesAndNamesFileLineAndColumn) {
    const std::string head = kHeader, rows = kRows;
    expect_words(refusal_of(head + rows + "4,,1\n"), {"t.csv:10:3: series_Nm", "missing"});
    expect_words(refusal_of(head + rows + "4,0.9\n"), {"t.csv:10:6: parallel_Nm", "missing"});
    expect_words(refusal_of(head + rows + "4,0.9,\n"), {"t.csv:10:7: parallel_Nm", "missing"});
    expect_words(refusal_of(head + rows + "4,nan,1\n"), {"t.csv:10:3: series_Nm", "'nan'", "finite"});
    expect_words(refusal_of(head + rows + "4,0.9,1 Nm\n"), {"t.csv:10:7: parallel_Nm", "'1 Nm'"});
    expect_words(refusal_of(head + rows + "4,\"0.9\"5,1\n"), {"t.csv:10:3: series_Nm"});
    expect_words(refusal_of(head + rows + "4,0.9,1,2\n"), {"t.csv:10:9: row", "three columns"});
    expect_words(refusal_of(head + rows + "3.5,0.9,1\n"), {"t.csv:10:1: angle_rad", "above the row before, 3.5", "one way alone"});
    expect_words(refusal_of(head + rows.substr(0, rows.rfind("3.5"))), {"t.csv", "rows", "7", "at least 8"});
}

TEST_F(CsvTest, RefusesAnotherHeader) {
    expect_words(refusal_of("angle_furlong,series_Nm,parallel_Nm\n" + std::string(kRows)), {"header", "angle_rad", "angle_furlong"});
    expect_words(refusal_of("angle_rad;series_Nm;parallel_Nm\n" + std::string(kRows)), {"t.csv:2:1: angle_rad: '0,"});
    expect_words(refusal_of("angle_rad,series_Nm\n" + std::string(kRows)), {"t.csv:1:20: header", "missing"});
    expect_words(refusal_of(std::string(kRows)), {"t.csv:1:1: header: no names", "a line with 'angle_rad,series_Nm,parallel_Nm'"});
    expect_words(refusal_of("# nothing\n"), {"t.csv:1:1: header", "missing"});
}

}  // namespace
}  // namespace fusee::profile
