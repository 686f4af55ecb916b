#include "fusee/gap_case/case_template.h"

#include <sstream>

#include "fusee/core/error.h"
#include "gap_case/fixture.h"
#include "refused.h"

// The empty case: readable once it is filled in, and until then the first empty cell is named.
namespace fusee::gap_case {
namespace {

using fixtures::CaseFolder;

TEST_F(CaseFolder, AnEmptyTemplateNamesItsFirstEmptyCell) {
    write_case_template(template_, folder_);
    EXPECT_NE(refusal().find("breakaway.csv:2:"), std::string::npos) << refusal();
    EXPECT_NE(refusal().find("load_torque_Nm: 96 of 96 rows have no number"), std::string::npos) << refusal();
    const Case known = [&] {
        put(fixtures::measured(template_));
        return read_case(folder_);
    }();
    write_case_template(template_, folder_);
    const Rows inputs = read_inputs(known, folder_);
    EXPECT_EQ(inputs.size(), known.rows.size());
    EXPECT_TRUE(std::isnan(inputs.cocontraction[0].theta_agonist));
    EXPECT_EQ(inputs.log[50].torque_agonist, known.rows.log[50].torque_agonist);
}

TEST_F(CaseFolder, SheetsSayUnitsSignsAndSetPoints) {
    const std::string sheets = text("BENCH.md");
    for (const char* words : {"small", "Degrees times 0.0174533", "positive when they wind", "0.1, 0.38, 0.66, 0.94, 1.22, 1.5 Nm",
                              "## breakaway.csv: 96", "## log.csv: 900 rows", "theta = 0: the springs relaxed", "in 3.15 s"})
        EXPECT_NE(sheets.find(words), std::string::npos) << words;
    template_.rest_deflection = 1.25;
    write_case_template(template_, folder_);
    EXPECT_NE(text("BENCH.md").find("both theta are 1.25 rad"), std::string::npos);
    for (const SpringPull& row : set_points(template_).spring_pull) EXPECT_GE(row.deflection, 1.25);
}

TEST_F(CaseFolder, SetPointsStayWithinTheRig) {
    const Rows rows = set_points(template_);
    for (const DeadBandRow& row : rows.dead_band) {
        EXPECT_GT(row.push_torque, 0.0);
        EXPECT_LT(row.push_torque, template_.rig.ratio() * template_.rig.springs.back().se_torque);
    }
    for (const StiffnessRow& row : rows.joint_stiffness) EXPECT_LT(std::abs(row.joint_torque), template_.rig.ratio() * 1.2);
    for (const LogRow& row : rows.log) EXPECT_TRUE(template_.torques.holds(row.torque_agonist)) << row.torque_agonist;
    EXPECT_EQ(rows.log.front().torque_agonist, rows.log.front().torque_antagonist);
    EXPECT_EQ(rows.log.front().joint_torque, 0.0);
}

/// docs/gap.md tells every key, column and word.
TEST_F(CaseFolder, TheManualTellsEveryKeyAndColumn) {
    const std::string manual = core::read_file(std::filesystem::path(FUSEE_SOURCE_DIR) / "docs" / "gap.md");
    const auto expect_told = [&manual](const std::string& name) { EXPECT_NE(manual.find("`" + name + "`"), std::string::npos) << name; };
    std::istringstream toml(text("case.toml"));
    for (std::string line; std::getline(toml, line);)
        if (const std::size_t equals = line.find(" = "); equals != std::string::npos && line[0] != '#') expect_told(line.substr(0, equals));
    for (const Experiment experiment : kAllExperiments) {
        const std::string csv = text(std::string(to_string(experiment)) + ".csv");
        std::istringstream header(csv.substr(0, csv.find('\n')));
        for (std::string column; std::getline(header, column, ',');) expect_told(column);
    }
}

TEST_F(CaseFolder, TemplateRefusesWhatNoCaseMayHold) {
    CaseTemplate wrong = template_;
    wrong.torques = {1.0, 1.0};
    EXPECT_EQ(field_refused([&] {
                  write_case_template(wrong, folder_);
                  return 0;
              }),
              "torques");
    wrong = template_;
    wrong.rig.capstan_radius = 15.0;
    EXPECT_EQ(field_refused([&] {
                  write_case_template(wrong, folder_);
                  return 0;
              }),
              "rig.capstan_radius_m");
    wrong = template_;
    wrong.rig.springs.clear();
    EXPECT_EQ(field_refused([&] {
                  write_case_template(wrong, folder_);
                  return 0;
              }),
              "rig.springs");
}

}  // namespace
}  // namespace fusee::gap_case
