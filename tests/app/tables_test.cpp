#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "app/run.h"
#include "fusee/core/units.h"

// Tables of spreadsheets and instruments, as a user gives them to each command.
namespace fusee::app {
namespace {

/// A table of the project as a German spreadsheet saves it.
std::string german(std::string csv) {
    std::replace(csv.begin(), csv.end(), ',', ';');
    std::string out;
    for (std::size_t i = 0; i < csv.size(); ++i) {
        const bool between = i > 0 && i + 1 < csv.size() && std::isdigit(static_cast<unsigned char>(csv[i - 1])) != 0 &&
                             std::isdigit(static_cast<unsigned char>(csv[i + 1])) != 0;
        if (csv[i] == '\n') out += '\r';
        out += csv[i] == '.' && between ? ',' : csv[i];
    }
    return "\xEF\xBB\xBF" + out;
}

class Tables : public Program {
protected:
    void SetUp() override {
        Program::SetUp();
        for (const char* file : {"measured_table.toml", "measured_table.csv"}) write(file, text(file));
    }
    static std::string text(const char* file) { return core::read_file(fs::path(FUSEE_SOURCE_DIR) / "profiles" / file); }
    /// What `check` says of the measured law with this table.
    [[nodiscard]] Ended checked(const std::string& csv, const std::string& columns = "") const {
        write("measured_table.csv", csv);
        write("measured_table.toml", text("measured_table.toml") + columns);
        return run("check measured_table.toml");
    }
};

TEST_F(Tables, ALawInAnyFormIsTheSameLaw) {
    const std::string plain = text("measured_table.csv");
    const Ended first = checked(plain);
    ASSERT_LT(first.code, 2) << first.all();
    const auto form = [&](const std::string& header) { return header + plain.substr(plain.find('\n', plain.find("angle_rad"))); };
    for (const std::string& csv :
         {german(plain), form("Angle (rad),Series / N\xC2\xB7m,PARALLEL [Nm]"), form("\"ANGLE_RAD\",\"series_Nm\",\"parallel_Nm\"")}) {
        const Ended again = checked(csv);
        EXPECT_EQ(again.code, first.code) << again.all();
        EXPECT_EQ(again.out, first.out);
    }
    const Ended foreign = checked(form("Winkel [rad],Innen [Nm],Aussen [Nm]"));
    EXPECT_EQ(foreign.code, 2);
    expect_words(foreign.all(), {"columns = { angle_rad = \"Winkel [rad]\""});
    EXPECT_EQ(checked(form("Winkel [rad],Innen [Nm],Aussen [Nm]"),
                      "\n[columns]\nangle_rad = \"Winkel [rad]\"\nseries_Nm = \"Innen [Nm]\"\nparallel_Nm = \"Aussen [Nm]\"\n")
                  .code,
              first.code);
    const Ended unknown = checked(plain, "\n[columns]\nangel_rad = \"x\"\ndecimal = \";\"\nseries_Nm = 1\n");
    EXPECT_EQ(unknown.code, 2);
    expect_words(unknown.all(), {"columns.angel_rad", "columns.decimal", "columns.series_Nm"});
}

TEST_F(Tables, DegreesAndMillinewtonsAreAskedAbout) {
    std::string degrees = "angle_rad,series_Nm,parallel_Nm\n", milli = degrees;
    std::istringstream rows(text("measured_table.csv"));
    for (std::string line; std::getline(rows, line);) {
        double angle = 0.0, series = 0.0, parallel = 0.0;
        if (std::sscanf(line.c_str(), "%lf,%lf,%lf", &angle, &series, &parallel) != 3) continue;
        degrees += fmt::format("{},{},{}\n", core::deg_from_rad(angle), series, parallel);
        milli += fmt::format("{},{},{}\n", angle, 1e3 * series, 1e3 * parallel);
    }
    const Ended asked = checked(degrees), torque = checked(milli);
    EXPECT_EQ(asked.code, 2);
    expect_words(asked.all(), {"are these degrees?", "angle_rad in deg", "angle_rad in rad"});
    EXPECT_EQ(torque.code, 2);
    expect_words(torque.all(), {"are these mNm?", "series_Nm in mNm"});
    EXPECT_LT(checked(degrees, "\n[columns]\nangle_rad = \"angle_rad in deg\"\n").code, 2);
}

TEST_F(Tables, IdentifySpringsCalibrateReadThem) {
    const auto same = [&](const char* file, const std::string& command, const std::string& words) {
        write("plain.csv", text(file));
        write("german.csv", german(text(file)));
        const Ended one = run(command + " plain.csv --json"), other = run(command + " german.csv --json");
        EXPECT_EQ(other.code, one.code) << other.all();
        EXPECT_EQ(one.code, 0) << one.all();
        expect_words(other.out, {words});
    };
    same("examples/break_away.csv", "identify", "\"gear_friction\": 0.2803");
    same("examples/coupon.csv", "calibrate", "bore_offset_mm");
    write(
        "foreign.csv",
        "Seite;Richtung;Motormoment [mNm];Lastmoment [Nm]\na;drive;100;0,08\na;backdrive;100;0,14\na;drive;500;0,4\na;backdrive;500;0,7\n");
    const Ended shown = run("identify foreign.csv");
    EXPECT_EQ(shown.code, 2);
    expect_words(shown.err, {"--columns 'side=Seite'", "--columns 'direction=Richtung'", "--columns 'motor_torque_Nm=Motormoment [mNm]'"});
    EXPECT_EQ(run("identify foreign.csv --columns side=Seite --columns direction=Richtung --columns 'motor_torque_Nm=Motormoment [mNm]' "
                  "--columns "
                  "'load_torque_Nm=Lastmoment [Nm]'")
                  .code,
              0);
    EXPECT_EQ(run("identify foreign.csv --columns side").code, 2);
}

TEST_F(Tables, CasesOfOthers) {
    const fs::path cases = fs::path(FUSEE_SOURCE_DIR) / "../shared/cases";
    if (!fs::exists(cases / "csv_dialects")) GTEST_SKIP() << "no " << cases / "csv_dialects";
    const fs::path dialects = cases / "csv_dialects";
    expect_words(run("identify '" + (dialects / "ba.csv").string() + "'").out, {"gear_friction = 0.28"});
    EXPECT_EQ(run("calibrate '" + (dialects / "co.csv").string() + "'").code, 0);
    const std::string good = core::read_file(dialects / "good.csv"), toml = core::read_file(dialects / "m.toml");
    write("m.toml", toml);
    write("measured_table.csv", good);
    const Ended plain = run("check m.toml");
    EXPECT_LT(plain.code, 2) << plain.all();
    write("measured_table.csv", german(good));
    EXPECT_EQ(run("check m.toml").out, plain.out);
    if (!fs::exists(cases / "identify_one_way")) GTEST_SKIP() << "no " << cases / "identify_one_way";
    const Ended one = run("identify '" + (cases / "identify_one_way/drive_only.csv").string() + "'"),
                both = run("identify '" + (cases / "identify_one_way/both.csv").string() + "'");
    EXPECT_EQ(one.code, 1);
    EXPECT_EQ(one.out.find("[rig]"), std::string::npos) << one.out;
    expect_words(one.out, {"cannot tell friction from an error of the torque constant", "mu = 0.142", "12.5 % less torque than stated",
                           "Measure backdrive"});
    EXPECT_EQ(both.code, 0);
    expect_words(both.out, {"less torque than stated", "gear_friction = 0.02"});
}

}  // namespace
}  // namespace fusee::app
