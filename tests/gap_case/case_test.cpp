#include "fusee/gap_case/case.h"

#include <fmt/format.h>

#include <cstdlib>
#include <set>

#include "fusee/core/error.h"
#include "gap_case/fixture.h"

// Reading and writing of gap cases: what comes back is what was written, and what cannot be is refused by name.
namespace fusee::gap_case {
namespace {

namespace fs = std::filesystem;
using fixtures::CaseFolder;

TEST_F(CaseFolder, ComesBackAsItWasWritten) {
    const Case read = read_case(folder_);
    const Rows wanted = fixtures::measured(template_);
    EXPECT_EQ(read.name, "small");
    EXPECT_EQ(read.sha256.size(), 64u);
    EXPECT_TRUE(read.remarks.empty());
    EXPECT_EQ(read.rig.joint_radius, 0.03);
    EXPECT_EQ(read.rig.pe_compression_rate, 2000.0);
    ASSERT_EQ(read.rig.springs.size(), 21u);
    EXPECT_DOUBLE_EQ(read.rig.springs[3].pe_torque, 0.04 * 3);
    EXPECT_EQ(read.tolerance.pe_preload, Tolerance{}.pe_preload);
    EXPECT_EQ(read.protocol.dead_band_release, 3.15);
    for (const Experiment experiment : kAllExperiments)
        EXPECT_EQ(read.rows.size(experiment), wanted.size(experiment)) << to_string(experiment);
    EXPECT_EQ(read.rows.breakaway[90].side, wanted.breakaway[90].side);
    EXPECT_EQ(read.rows.breakaway[90].load_torque, wanted.breakaway[90].load_torque);
    EXPECT_EQ(read.rows.breakaway[90].line, 92u);
    EXPECT_EQ(read.rows.spring_pull[200].series, wanted.spring_pull[200].series);
    EXPECT_EQ(read.rows.spring_pull[200].load, wanted.spring_pull[200].load);
    EXPECT_EQ(read.rows.dead_band[4].repeat, 2);
    EXPECT_EQ(read.rows.dead_band[4].width, wanted.dead_band[4].width);
    EXPECT_EQ(read.rows.joint_stiffness[60].phase, StiffnessPhase::kLoadDown);
    EXPECT_EQ(read.rows.cocontraction.back().up, false);
    EXPECT_EQ(read.rows.log[123].q, wanted.log[123].q);
    EXPECT_EQ(read_case(folder_).sha256, read.sha256);
    const std::string before = text("log.csv");
    write_rows(read, read.rows, folder_);
    EXPECT_EQ(text("log.csv"), before);
    edit("log.csv", "0.01,", "0.011,");
    EXPECT_NE(read_case(folder_).sha256, read.sha256);
}

TEST_F(CaseFolder, LeftOutTablesTakeTheDefaultsAndSaySo) {
    const std::string toml = text("case.toml");
    write("case.toml",
          toml.substr(0, toml.find("[tolerance]")) + "[sensors]\nlog_rate_Hz = 100\n[experiments]\ndead_band = \"dead_band.csv\"\n");
    const Case read = read_case(folder_);
    EXPECT_EQ(read.tolerance.radii, 0.003);
    EXPECT_EQ(read.rows.size(), read.rows.dead_band.size());
    EXPECT_TRUE(remarked("[tolerance] uses defaults for: gear_load_friction = 0.02"));
    EXPECT_TRUE(remarked("[sensors] uses defaults for: encoder_step_rad"));
    EXPECT_TRUE(remarked("[protocol]"));
    EXPECT_TRUE(remarked("21 rows in all"));
}

TEST_F(CaseFolder, SeveralFilesOfAnExperimentAreJoinedAndPartedAgain) {
    Rows rows = fixtures::measured(template_);
    files_.files[Experiment::kDeadBand] = {"dead_band.csv", "second day/dead_band.csv"};
    rows.parts[Experiment::kDeadBand] = {15, 6};
    put(rows);
    edit("case.toml", "\"dead_band.csv\"", "[\"dead_band.csv\", \"second day/dead_band.csv\"]");
    const Case read = read_case(folder_);
    EXPECT_EQ(read.rows.dead_band.size(), 21u);
    EXPECT_EQ(read.rows.parts.at(Experiment::kDeadBand), (std::vector<std::size_t>{15, 6}));
    write_rows(read, read.rows, folder_ / "again");
    EXPECT_EQ(text("again/second day/dead_band.csv"), text("second day/dead_band.csv"));
}

TEST_F(CaseFolder, APublishedTableMayHaveTheWidthAlone) {
    write("dead_band.csv", "cocontraction_Nm,width_rad\n0.12,0.7\n0.5,0.6\n");
    const Case read = read_case(folder_);
    EXPECT_TRUE(read.rows.dead_band_width_only);
    EXPECT_EQ(read.rows.dead_band[1].width, 0.6);
    EXPECT_EQ(read.rows.dead_band[1].repeat, 1);
    EXPECT_TRUE(std::isnan(read.rows.dead_band[1].q_low));
    EXPECT_TRUE(std::isnan(read.rows.dead_band[1].push_torque));
    EXPECT_TRUE(remarked("widths only"));
    write_rows(read, read.rows, folder_);
    EXPECT_EQ(text("dead_band.csv"), "cocontraction_Nm,width_rad\n0.12,0.7\n0.5,0.6\n");
}

TEST_F(CaseFolder, InputsNeedNoMeasuredColumns) {
    const Case read = read_case(folder_);
    const fs::path other = folder_ / "other";
    fs::create_directories(other);
    EXPECT_THROW((void)read_inputs(read, other), core::InvalidInput);
    write("other/breakaway.csv", "side,direction,motor_torque_Nm\nagonist,drive,0.3\n");
    write("other/log.csv", "t_s,motor_torque_agonist_Nm,motor_torque_antagonist_Nm,joint_torque_Nm,q_rad\n0,1,1,0,\n0.01,1,1,0,0.25\n");
    Rows rows = read_inputs(read, other);
    EXPECT_EQ(rows.size(), 3u);
    EXPECT_TRUE(std::isnan(rows.breakaway[0].load_torque));
    EXPECT_TRUE(std::isnan(rows.log[0].q));
    EXPECT_EQ(rows.log[1].q, 0.25);
    rows.breakaway[0].load_torque = 0.1 + 0.2;
    write_rows(read, rows, folder_ / "predicted");
    EXPECT_EQ(text("predicted/breakaway.csv"), "side,direction,motor_torque_Nm,load_torque_Nm\nagonist,drive,0.3,0.30000000000000004\n");
    EXPECT_FALSE(fs::exists(folder_ / "predicted" / "dead_band.csv"));
}

TEST_F(CaseFolder, TenRowsAreALimitationNotAnError) {
    write("breakaway.csv", "side,direction,motor_torque_Nm,load_torque_Nm\nagonist,drive,0.5,0.4\nagonist,backdrive,0.5,0.66\n");
    const std::string toml = text("case.toml");
    write("case.toml", toml.substr(0, toml.find("[experiments]")) + "[experiments]\nbreakaway = \"breakaway.csv\"\n");
    EXPECT_TRUE(remarked("2 rows in all"));
    EXPECT_TRUE(remarked("breakaway: 2 rows only"));
}

TEST_F(CaseFolder, ALongFileIsThinnedByAConstantStride) {
    std::string csv = "cocontraction_Nm,phase,joint_torque_Nm,q_rad\n";
    const std::size_t rows = 2 * kLongestTable + 7;
    for (std::size_t i = 0; i < rows; ++i) csv += fmt::format("1,load+,{0},{0}\n", 1e-5 * static_cast<double>(i));
    write("joint_stiffness.csv", csv);
    const Case read = read_case(folder_);
    ASSERT_EQ(read.rows.joint_stiffness.size(), (rows + 3) / 4);
    for (std::size_t i = 0; i < read.rows.joint_stiffness.size(); ++i)
        ASSERT_EQ(read.rows.joint_stiffness[i].q, 1e-5 * static_cast<double>(4 * i));
    EXPECT_TRUE(remarked("every 4th row is used, 10002 of 40007"));
    write("joint_stiffness.csv", csv + "1,load+,0.4,none\n");
    EXPECT_NE(refusal().find("joint_stiffness.csv:40009:"), std::string::npos) << refusal();
}

TEST_F(CaseFolder, OfALongLogTheBeginningIsUsed) {
    Rows rows = fixtures::measured(template_);
    for (LogRow& row : rows.log) row.time *= 20.0;  // 9 s become 180 s
    put(rows);
    edit("case.toml", "log_rate_Hz = 100", "log_rate_Hz = 5");
    EXPECT_EQ(read_case(folder_).rows.log.size(), 301u);
    EXPECT_TRUE(remarked("log.csv: of 900 rows the first 60 s are used, 599 rows are left out"));
}

/// A change of one file, and what the refusal says.
struct Broken {
    const char* name;
    const char *file, *from, *to;
    std::vector<std::string> words;
};

class Refuses : public CaseFolder, public testing::WithParamInterface<Broken> {};

TEST_P(Refuses, ByName) {
    edit(GetParam().file, GetParam().from, GetParam().to);
    const std::string said = refusal();
    EXPECT_NE(said.find(GetParam().file), std::string::npos) << said;
    for (const std::string& word : GetParam().words) EXPECT_NE(said.find(word), std::string::npos) << "'" << word << "' in " << said;
}

const Broken kBroken[] = {
    {"mm_for_m",
     "case.toml",
     "capstan_radius_m = 0.015",
     "capstan_radius_m = 15",
     {":5:1: rig.capstan_radius_m: 15", "a number in m, 0.0005 to 0.5"}},
    {"per_cent", "case.toml", "gear_load_friction = 0.25", "gear_load_friction = 25", {"rig.gear_load_friction: 25", "0 to 0.95"}},
    {"degrees", "case.toml", "encoder_step_rad = 0.000767", "encoder_step_rad = 0.0439", {"sensors.encoder_step_rad", "in rad"}},
    {"milliseconds", "case.toml", "motor_ramp_s = 0.6", "motor_ramp_s = 600", {"protocol.motor_ramp_s: 600", "in s"}},
    {"another_ramp",
     "case.toml",
     "motor_ramp = \"straight\"",
     "motor_ramp = \"steep\"",
     {"protocol.motor_ramp: \"steep\"", "\"straight\" or \"smooth\""}},
    {"N_per_mm", "case.toml", "rate_N_per_m = 2000", "rate_N_per_m = 2", {"rig.pe_compression_rate_N_per_m", "N/m"}},
    {"too_soft", "case.toml", "rate_N_per_m = 2000", "rate_N_per_m = 10", {"rig.pe_compression_rate_N_per_m", "deflect by"}},
    {"unknown_key",
     "case.toml",
     "capstan_radius_m",
     "capstan_radius_mm",
     {"rig.capstan_radius_mm: unknown key", "capstan_radius_m, joint_radius_m"}},
    {"unknown_table", "case.toml", "[sensors]", "[sensor]", {"sensor: unknown table", "[sensors]"}},
    {"unknown_experiment", "case.toml", "log = ", "logs = ", {"experiments.logs: unknown key", "joint_stiffness"}},
    {"missing_key", "case.toml", "motor_inertia_kgm2", "#", {"case.toml:4:2: rig.motor_inertia_kgm2: missing", "kg m^2"}},
    {"text_for_number", "case.toml", "joint_radius_m = 0.03", "joint_radius_m = \"0.03\"", {"rig.joint_radius_m: \"0.03\"", "a number"}},
    {"nan", "case.toml", "joint_radius_m = 0.03", "joint_radius_m = nan", {"rig.joint_radius_m: nan"}},
    {"no_noise", "case.toml", "torque_noise_Nm = 0.0015", "torque_noise_Nm = 0", {"sensors.torque_noise_Nm", "scatter"}},
    {"no_toml", "case.toml", "[sensors]", "[sensors", {"not valid TOML"}},
    {"missing_file", "case.toml", "\"log.csv\"", "\"log2.csv\"", {"experiments.log: log2.csv not found: restore it or delete its line"}},
    {"missing_springs", "case.toml", "\"nominal_springs.csv\"", "\"other.csv\"", {"rig.springs: other.csv not found: restore it"}},
    {"climbs", "case.toml", "\"log.csv\"", "\"../log.csv\"", {"experiments.log", "inside the case's folder"}},
    {"twice", "case.toml", "\"log.csv\"", "\"cocontraction.csv\"", {"\"cocontraction.csv\"", "named twice"}},
    {"springs_twice", "case.toml", "\"nominal_springs.csv\"", "\"log.csv\"", {"named twice"}},
    {"preload", "nominal_springs.csv", "\n0,0,0\n", "\n0,0.1,0\n", {":2:3: se_torque_Nm: 0.1", "without preload"}},
    {"springs_fall", "nominal_springs.csv", "\n0.4,", "\n0.1,", {":4:1: deflection_rad: 0.1", "above the row before"}},
    {"torque_falls", "nominal_springs.csv", "\n0.4,0.12,", "\n0.4,0.01,", {":4:5: se_torque_Nm: 0.01", "not below"}},
    {"gap", "breakaway.csv", "agonist,backdrive,0.1,0.1", "agonist,backdrive,,0.1", {":2:19: motor_torque_Nm: (missing)"}},
    {"side", "breakaway.csv", "\nagonist", "\nleft", {":2:1: side: 'left'", "agonist or antagonist"}},
    {"phase", "cocontraction.csv", "\nup", "\nrising", {":2:1: phase: 'rising'", "up or down"}},
    {"column", "joint_stiffness.csv", "q_rad", "joint", {"header: 'q_rad' (missing)"}},
    {"no_width", "dead_band.csv", "q_low_rad", "low", {"q_low_rad and q_high_rad, or width_rad alone"}},
    {"repeat", "dead_band.csv", "0.1,1,", "0.1,1.5,", {":2:5: repeat: 1.5", "a whole number"}},
    {"time", "log.csv", "\n0.02,", "\n0.01,", {":4:1: t_s: 0.01", "after the row before"}},
    {"theta_degrees", "log.csv", ",1.6,1.6,", ",91.7,91.7,", {"theta_agonist_rad: 91.7", "are these degrees?"}},
    {"pull_down", "dead_band.csv", "\n0.1,", "\n-0.1,", {"cocontraction_Nm: -0.1", "winds the capstan's cable in"}},
    {"Ncm", "breakaway.csv", ",0.1,0.1333", ",10,133.3", {"load_torque_Nm: 133", "the springs have 2 Nm"}},
};
INSTANTIATE_TEST_SUITE_P(Case, Refuses, testing::ValuesIn(kBroken), [](const auto& tested) { return std::string(tested.param.name); });

/// What only many rows show.
TEST_F(CaseFolder, RefusesUnitsSignsAndSidesThatManyRowsContradict) {
    const Rows good = fixtures::measured(template_);
    const auto expect_refused = [&](const std::function<void(Rows&)>& breaks, std::initializer_list<std::string> words) {
        Rows rows = good;
        breaks(rows);
        put(rows);
        const std::string said = refusal();
        for (const std::string& word : words) EXPECT_NE(said.find(word), std::string::npos) << "'" << word << "' in " << said;
    };
    expect_refused(
        [](Rows& r) {
            for (auto& row : r.breakaway) row.backdrive = !row.backdrive;
        },
        {"breakaway.csv: direction", "swapped"});
    expect_refused(
        [](Rows& r) {
            for (auto& row : r.spring_pull) row.torque *= 100.0 / 9.0;
        },
        {"spring_pull.csv: torque_Nm", "Nm at the capstan"});
    expect_refused(
        [](Rows& r) {
            for (auto& row : r.dead_band) std::swap(row.q_low, row.q_high);
        },
        {"dead_band.csv: q_low_rad"});
    expect_refused(
        [](Rows& r) {
            for (auto& row : r.joint_stiffness) row.q = -row.q;
        },
        {"joint_stiffness.csv: q_rad", "wrong sign"});
    expect_refused(
        [](Rows& r) {
            for (auto& row : r.log) std::swap(row.theta_agonist, row.theta_antagonist);
        },
        {"log.csv: ", "swapped"});
    expect_refused(
        [](Rows& r) {
            for (auto& row : r.log) std::swap(row.torque_agonist, row.torque_antagonist);
        },
        {"log.csv: motor_torque_agonist_Nm"});
    expect_refused(
        [](Rows& r) {
            for (auto& row : r.log) row.time *= 1000.0;
        },
        {"log.csv: t_s", "milliseconds"});
    const double step = Sensors{}.encoder_step;
    const auto read_off = [step](double angle, double unit) { return std::round(angle / step) * step * unit; };
    expect_refused(
        [&](Rows& r) {
            for (auto& row : r.joint_stiffness) row.q = read_off(0.1 * row.q, 180.0 / core::kPi);
        },
        {"joint_stiffness.csv: q_rad", "degrees"});
    expect_refused(
        [](Rows& r) {
            for (auto& row : r.cocontraction) row.motor_torque *= 1e-3;
        },
        {"cocontraction.csv: motor_torque_Nm: at most 0.0015", "another unit"});
    put(good);
    EXPECT_EQ(refusal(), "accepted");
}

/// The springs' file in other units, with one experiment or with all.
class SpringsInOtherUnits : public CaseFolder {
protected:
    void SetUp() override {
        CaseFolder::SetUp();
        toml_ = text("case.toml");
    }
    /// What is said of springs with deflections times `x`, torques times `se` and `pe`, and of `experiment` alone ("": all).
    [[nodiscard]] std::string said(const std::string& experiment, double x, double se, double pe) const {
        std::string csv = "deflection_rad,se_torque_Nm,pe_torque_Nm\n";
        for (const NominalRig::SpringRow& row : template_.rig.springs)
            csv += fmt::format("{},{},{}\n", x * row.deflection, se * row.se_torque, pe * row.pe_torque);
        write("nominal_springs.csv", csv);
        const std::string alone = fmt::format("[experiments]\n{0} = \"{0}.csv\"\n", experiment);
        write("case.toml", experiment.empty() ? toml_ : toml_.substr(0, toml_.find("[experiments]")) + alone);
        return refusal();
    }
    static void expect_words(const std::string& said, std::initializer_list<std::string> words) {
        for (const std::string& word : words) EXPECT_NE(said.find(word), std::string::npos) << "'" << word << "' in " << said;
    }
    std::string toml_;
};

TEST_F(SpringsInOtherUnits, AreRefusedWithTheUnitThatTheyMayHave) {
    for (const Experiment experiment : kAllExperiments)
        EXPECT_EQ(said(to_string(experiment), 1, 1, 1), "accepted") << to_string(experiment);
    expect_words(said("cocontraction", 1, 100, 1), {"Ncm"});
    expect_words(said("cocontraction", 1, 20, 20), {"cocontraction.csv: theta_agonist_rad", "carry 20 times the motor torques", "kgf cm"});
    expect_words(said("log", 1, 20, 20), {"log.csv: theta_agonist_rad", "kgf cm"});
    expect_words(said("cocontraction", 180.0 / core::kPi / 4.0, 1, 1), {"carry 0.0698 times", "are the deflections degrees?"});
    expect_words(said("spring_pull", 1, 20, 20), {"spring_pull.csv: torque_Nm: 0.05 times"});
    for (const char* experiment : {"", "breakaway", "dead_band", "joint_stiffness", "cocontraction", "log"}) {
        SCOPED_TRACE(experiment);
        expect_words(said(experiment, 0.01, 1, 1), {"nominal_springs.csv: deflection_rad: at most 0.04"});
        for (const auto& [se, pe] : {std::pair{100, 1}, {1, 100}, {100, 100}}) EXPECT_NE(said(experiment, 1, se, pe), "accepted");
    }
}

TEST_F(SpringsInOtherUnits, CurvesThatDoNotRiseAreRefusedWhereTheyAreRead) {
    edit("nominal_springs.csv", "\n0.4,0.12,", "\n0.4,0.06,");
    expect_words(refusal(), {"nominal_springs.csv: se_torque_Nm, pe_torque_Nm: a torque that does not rise at", "both torques rising"});
}

TEST_F(CaseFolder, LoadsFarOffTheMotorTorquesAreAnotherUnit) {
    Rows rows = fixtures::measured(template_);
    for (BreakAway& row : rows.breakaway) {
        row.load_torque *= 100.0;
        row.motor_torque = std::min(row.motor_torque, 0.3);
    }
    rows.breakaway.erase(rows.breakaway.begin() + 4, rows.breakaway.end());
    put(rows);
    const std::string said = refusal();
    EXPECT_NE(said.find("breakaway.csv: load_torque_Nm: 133 times the motor torques"), std::string::npos) << said;
    EXPECT_NE(said.find("are the torques Ncm?"), std::string::npos) << said;
}

TEST_F(CaseFolder, AFileUnderTwoNamesIsRefused) {
    for (const char* other : {"./dead_band.csv", "second/../dead_band.csv", "link.csv"}) {
        if (std::string(other) == "link.csv") fs::create_symlink("dead_band.csv", folder_ / other);
        const std::string toml = text("case.toml");
        edit("case.toml", "\"dead_band.csv\"", fmt::format("[\"dead_band.csv\", \"{}\"]", other));
        const std::string said = refusal();
        const bool climbs = std::string(other).find("..") != std::string::npos;
        EXPECT_NE(said.find(climbs ? "inside the case's folder" : "named twice"), std::string::npos) << said;
        write("case.toml", toml);
    }
}

/// Measured instead of commanded co-contractions: each row would be a separate loop from rest.
TEST_F(CaseFolder, CocontractionsThatScatterAreOneLevel) {
    Rows rows = fixtures::measured(template_);
    const std::vector<StiffnessRow> commanded = rows.joint_stiffness;
    for (std::size_t i = 0; i < commanded.size(); ++i)
        rows.joint_stiffness[i].cocontraction += 1e-3 * std::sin(7.0 * static_cast<double>(i));
    put(rows);
    const Case read = read_case(folder_);
    std::set<double> levels;
    for (std::size_t i = 0; i < commanded.size(); ++i) {
        EXPECT_NEAR(read.rows.joint_stiffness[i].cocontraction, commanded[i].cocontraction, 2e-4) << i;
        levels.insert(read.rows.joint_stiffness[i].cocontraction);
    }
    EXPECT_EQ(levels.size(), 3u);
    EXPECT_TRUE(remarked("joint_stiffness.csv: co-contractions within 1 % of each other are one level"));
    EXPECT_EQ(read_inputs(read, folder_).joint_stiffness[5].cocontraction, rows.joint_stiffness[5].cocontraction) << "inputs stay";
    put(fixtures::measured(template_));
    EXPECT_FALSE(remarked("one level"));
}

TEST_F(CaseFolder, OneSidedBreakAwayOnTheWrongSideIsARemark) {
    Rows rows = fixtures::measured(template_);
    for (BreakAway& row : rows.breakaway) row.load_torque *= 1.3;  // a torque scale: the drive loads now lie above the motor torque
    put(rows);
    EXPECT_TRUE(remarked("loads lie on the wrong side"));
}

TEST_F(CaseFolder, WhatIsNoTableIsRefused) {
    write("log.csv", "Dear colleague,\nthe log is attached.\n");
    EXPECT_NE(refusal().find("log.csv:1:"), std::string::npos) << refusal();
    std::string garbage(100'000, '\0');
    for (std::size_t i = 0; i < garbage.size(); ++i) garbage[i] = static_cast<char>(i * 7919 % 251);
    write("log.csv", garbage);
    EXPECT_NE(refusal().find("log.csv:"), std::string::npos);
    EXPECT_LT(refusal().size(), 600u);
    write("log.csv", "");
    EXPECT_NE(refusal().find("header: (missing)"), std::string::npos) << refusal();
    write("case.toml", garbage);
    EXPECT_NE(refusal().find("case.toml:"), std::string::npos) << refusal();
    fs::remove(folder_ / "case.toml");
    EXPECT_THROW((void)read_case(folder_), core::IoError);
}

TEST_F(CaseFolder, TellsABenchCase) {
    EXPECT_EQ(kind_of_case(folder_), CaseKind::kJoint);
    edit("case.toml", "[rig]", "[bench]");
    EXPECT_EQ(kind_of_case(folder_), CaseKind::kElement);
    EXPECT_NE(refusal().find("bench"), std::string::npos);
}

TEST(OpenCases, AreReadWithoutARemark) {
    const char* open = std::getenv("FUSEE_GAP_CASES");
    if (open == nullptr) GTEST_SKIP() << "FUSEE_GAP_CASES does not name a folder of cases";
    std::size_t read = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(open)) {
        if (!fs::exists(entry.path() / "case.toml")) continue;
        const Case gap_case = read_case(entry.path());
        EXPECT_TRUE(gap_case.remarks.empty()) << gap_case.name << ": " << gap_case.remarks.front();
        EXPECT_EQ(read_inputs(gap_case, entry.path()).size(), gap_case.rows.size());
        ++read;
    }
    EXPECT_GT(read, 0u);
}

}  // namespace
}  // namespace fusee::gap_case
