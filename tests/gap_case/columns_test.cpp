#include <fmt/format.h>

#include <cmath>

#include "fusee/gap_case/case.h"
#include "fusee/gap_case/likely_unit.h"
#include "gap_case/fixture.h"

// Files as labs log them: other names, other units, rows without a number.
namespace fusee::gap_case {
namespace {

using fixtures::CaseFolder;

constexpr double kNmPerA = 0.35, kCounts = 8192.0;
constexpr const char* kMapping = R"(
[columns.log]
t_s = { column = "stamp_ms", unit = "ms" }
motor_torque_agonist_Nm = { column = "i_ago", unit = "A", Nm_per_A = 0.35 }
motor_torque_antagonist_Nm = { column = "i_ant", unit = "A", Nm_per_A = 0.35 }
joint_torque_Nm = { column = "load_mNm", unit = "mNm" }
theta_agonist_rad = { column = "ago_deg", unit = "deg" }
theta_antagonist_rad = { column = "ant_counts", unit = "count", counts_per_turn = 8192 }
q_rad = { column = "pos", factor = -1 }
[columns.dead_band]
q_low_rad = "low"
)";

class LabFiles : public CaseFolder {
protected:
    void SetUp() override {
        CaseFolder::SetUp();
        rows_ = fixtures::measured(template_);
        put_lab_log();
        edit("dead_band.csv", "q_low_rad", "low");
        toml_ = text("case.toml");
        write("case.toml", toml_ + kMapping);
    }
    /// What is said of another [columns.log].
    [[nodiscard]] std::string said(const std::string& line) const {
        write("case.toml", toml_ + "[columns.log]\n" + line + "\n[columns.dead_band]\nq_low_rad = \"low\"\n");
        return refusal();
    }
    /// Rewrites log.csv as a position-controlled rig logs it: milliseconds, amperes, degrees, counts; one sign turned.
    void put_lab_log() const {
        std::string csv = "stamp_ms,i_ago,i_ant,load_mNm,ago_deg,ant_counts,pos\n";
        for (const LogRow& row : rows_.log)
            csv += fmt::format("{},{},{},{},{},{},{}\n", 1e3 * row.time, row.torque_agonist / kNmPerA, row.torque_antagonist / kNmPerA,
                               1e3 * row.joint_torque, row.theta_agonist * 180.0 / core::kPi,
                               row.theta_antagonist * kCounts / (2.0 * core::kPi), -row.q);
        write("log.csv", csv);
    }
    Rows rows_;
    std::string toml_;
};

TEST_F(LabFiles, HaveTheRowsOfTheSameFilesInTheFormat) {
    const Rows read = read_case(folder_).rows;
    ASSERT_EQ(read.log.size(), rows_.log.size());
    for (std::size_t i = 0; i < read.log.size(); ++i) {
        EXPECT_NEAR(read.log[i].time, rows_.log[i].time, 1e-12);
        EXPECT_NEAR(read.log[i].torque_agonist, rows_.log[i].torque_agonist, 1e-12);
        EXPECT_NEAR(read.log[i].torque_antagonist, rows_.log[i].torque_antagonist, 1e-12);
        EXPECT_NEAR(read.log[i].joint_torque, rows_.log[i].joint_torque, 1e-12);
        EXPECT_NEAR(read.log[i].theta_agonist, rows_.log[i].theta_agonist, 1e-12);
        EXPECT_NEAR(read.log[i].theta_antagonist, rows_.log[i].theta_antagonist, 1e-12);
        EXPECT_NEAR(read.log[i].q, rows_.log[i].q, 1e-12);
    }
    EXPECT_EQ(read.dead_band[4].q_low, rows_.dead_band[4].q_low);
}

TEST_F(LabFiles, AMistakeInTheMappingIsNamedWithWhatIsAllowed) {
    const auto expect_words = [&](const std::string& line, std::initializer_list<std::string> words) {
        const std::string text = said(line);
        for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << line << ": " << text;
    };
    expect_words("speed = \"v\"", {"columns.log.speed", "unknown key", "theta_agonist_rad"});
    expect_words("t_s = { column = \"stamp_ms\", unit = \"deg\" }", {"columns.log.t_s.unit", "\"deg\"", "s, ms, us"});
    expect_words("t_s = { unit = \"ms\" }", {"columns.log.t_s.column", "missing"});
    expect_words("q_rad = { column = \"pos\", unit = \"count\" }", {"columns.log.q_rad.counts_per_turn", "missing"});
    expect_words("joint_torque_Nm = { column = \"x\", unit = \"A\", Nm_per_A = 0 }", {"Nm_per_A", "other than 0"});
    expect_words("q_rad = { column = \"pos\", scale = 2 }", {"columns.log.q_rad.scale", "unknown key", "factor"});
    expect_words("t_s = \"seconds\"", {"log.csv:1:", "seconds"});
    write("case.toml", toml_ + "[columns.logs]\nt_s = \"x\"\n");
    EXPECT_NE(refusal().find("columns.logs"), std::string::npos) << refusal();
}

TEST_F(LabFiles, AValueOutOfRangeIsToldAsItStandsAndConverted) {
    edit("log.csv", "\n0,", "\n0,1e6,0,0,0,0,0\n1,");
    EXPECT_NE(refusal().find("1e+06, which is 350000 as motor_torque_agonist_Nm"), std::string::npos) << refusal();
}

TEST_F(CaseFolder, RowsWithoutANumberAreLeftOutAndCounted) {
    Rows rows = fixtures::measured(template_);
    const std::size_t all = rows.dead_band.size();
    std::string csv = text("dead_band.csv");
    for (const char* gap : {"nan", "", "-Inf"}) {  // the last cells of three lines
        const std::size_t from = csv.find('\n', csv.size() / 2 + std::string(gap).size() * 30), to = csv.find('\n', from + 1);
        csv.replace(csv.rfind(',', to) + 1, to - csv.rfind(',', to) - 1, gap);
    }
    write("dead_band.csv", csv);
    EXPECT_EQ(read_case(folder_).rows.dead_band.size(), all - 3);
    EXPECT_TRUE(remarked(fmt::format("dead_band.csv: 3 of {} rows are left out, without a number in a measured column: lines ", all)));
    const std::size_t first = csv.find('\n') + 1;  // what was commanded has to be known
    write("dead_band.csv", csv.replace(first, csv.find(',', first) - first, "nan"));
    EXPECT_NE(refusal().find("cocontraction_Nm"), std::string::npos) << refusal();
}

TEST_F(CaseFolder, AFileThatIsMostlyGapsIsRefused) {
    std::string csv = "cocontraction_Nm,repeat,push_torque_Nm,q_low_rad,q_high_rad\n";
    for (int i = 0; i < 20; ++i) csv += i % 3 == 0 ? "0.5,1,1,-0.1,0.1\n" : "0.5,1,1,-0.1,\n";
    write("dead_band.csv", csv);
    EXPECT_NE(refusal().find("dead_band.csv:3:14: q_high_rad: 13 of 20 rows"), std::string::npos) << refusal();
    EXPECT_NO_THROW((void)read_nominal(folder_));
}

TEST_F(CaseFolder, ARowOfALoopThatIsLeftOutKeepsItsPlace) {
    Rows rows = fixtures::measured(template_);
    std::string csv = text("joint_stiffness.csv");
    const std::size_t line = csv.find('\n', csv.find('\n', csv.find('\n') + 1) + 1), end = csv.find('\n', line + 1);
    csv.replace(csv.rfind(',', end) + 1, end - csv.rfind(',', end) - 1, "NaN");
    write("joint_stiffness.csv", csv);
    const Rows read = read_case(folder_).rows;
    ASSERT_EQ(read.joint_stiffness.size(), rows.joint_stiffness.size() - 1);
    EXPECT_EQ(read.joint_stiffness[1].row, 2U);
    EXPECT_EQ(read.joint_stiffness[2].row, 4U);
}

TEST(StepOf, IsTheLeastDifferenceBeyondRounding) {
    EXPECT_NEAR(step_of({0.3, 0.0, 0.1, 0.1, 0.1 + 1e-16, 0.8}), 0.1, 1e-12);
    EXPECT_EQ(step_of({2.0, 2.0}), 0.0);
    EXPECT_EQ(step_of({}), 0.0);
}

}  // namespace
}  // namespace fusee::gap_case
