#include <gtest/gtest.h>

#include "fusee/core/file.h"
#include "gap_case/fixture.h"
#include "refused.h"
#include "subsystem/fixture.h"

namespace fs = std::filesystem;

namespace fusee::subsystem {
namespace {

using fixtures::CamRig;
using fixtures::measure;
using fixtures::names_of;
using fixtures::says;

struct CamCase {
    CamRig rig;
    const char* effects;
    double size;       ///< of the only effect; 0: not checked
    double tolerance;  ///< of it, relative
};

// Known: what was put in is named with its size, and nothing else is; a rig without a fault is named none.
TEST(DiagnoseCamJoint, NamesWhatTheRigHas) {
    const CamCase cases[] = {
        {{}, "", 0.0, 0.0},
        {{.scale = -0.22}, "law.scale", -0.22, 0.02},
        {{.series = 4e-4}, "law.series", 4e-4, 0.05},
        {{.preload = 0.01}, "law.preload", 0.01, 0.05},
        {{.hysteresis = 0.05}, "law.hysteresis", 0.05, 0.1},
        {{.coulomb = 2.0}, "law.coulomb", 2.0, 0.1},
        {{.tilt = 0.1, .bow = 0.15}, "law.arm", 0.0, 0.0},
        {{.scale = -0.22, .coulomb = 1.5}, "law.coulomb, law.scale", 0.0, 0.0},
    };
    unsigned seed = 60;
    for (const CamCase& c : cases) {
        SCOPED_TRACE(*c.effects == '\0' ? "no fault" : c.effects);
        const diagnosis::Diagnosis d = diagnose(measure(c.rig, seed++), {.jobs = 1, .progress = {}});
        EXPECT_EQ(names_of(d), c.effects);
        EXPECT_EQ(d.verdict, *c.effects == '\0' ? diagnosis::VerdictKind::kNone : diagnosis::VerdictKind::kIdentified);
        EXPECT_LT(d.gap.heldout_after, 1.2);  // sigma; the noise alone is 1
        ASSERT_EQ(d.build.size(), 2u);
        EXPECT_EQ(d.build[0].first, "sensor.torque_offset pull_first.csv");
        EXPECT_NEAR(d.build[0].second.value, 0.8, 0.15);
        EXPECT_NEAR(d.build[1].second.value, -0.8, 0.15);
        if (c.size == 0.0 || d.effects.size() != 1) continue;
        EXPECT_NEAR(d.effects.front().parameter.value, c.size, c.tolerance * std::abs(c.size));
    }
}

/// The transfer of one effect alone to a file.
diagnosis::Transfer transfer_to(const diagnosis::Diagnosis& d, const std::string& id, const std::string& heldout) {
    for (const diagnosis::Transfer& t : d.transfer)
        if (t.effects.size() == 1 && t.effects.front().id == id && t.heldout == heldout) return t;
    return {};
}

// A compliance that only one of the two set-ups has fits that file and spoils the other: no compliance of the joint.
TEST(DiagnoseCamJoint, RefusesWhatTheHeldOutCamDoesNotHave) {
    Case subsystem_case = measure(CamRig{.scale = -0.2}, 70);
    subsystem_case.records[0] = measure(CamRig{.scale = -0.2, .series = 3e-4}, 71).records[0];
    const diagnosis::Diagnosis d = diagnose(subsystem_case, {.jobs = 1, .progress = {}});
    EXPECT_NE(names_of(d).find("law.scale"), std::string::npos) << names_of(d);
    EXPECT_EQ(names_of(d).find("law.series"), std::string::npos) << names_of(d);
    EXPECT_GT(d.gap.heldout_after, 3.0);
    EXPECT_TRUE(says(d, "what remains: "));
    const diagnosis::Transfer scale = transfer_to(d, "law.scale", "pull_second.csv");
    EXPECT_LT(scale.heldout_after, 0.8 * scale.heldout_before);
    ASSERT_EQ(scale.parameters.size(), 1u);
    EXPECT_LT(scale.parameters[0].value, -0.15);
}

TEST(DiagnoseCamJoint, OneFileHoldsOutItsPartsAndSaysSo) {
    Case subsystem_case = measure(CamRig{.scale = -0.22}, 72);
    subsystem_case.records.pop_back();
    const diagnosis::Diagnosis d = diagnose(subsystem_case, {.jobs = 1, .progress = {}});
    EXPECT_NE(names_of(d).find("law.scale"), std::string::npos) << names_of(d);
    EXPECT_TRUE(says(d, "one file: no other cam is held out"));
    EXPECT_TRUE(d.transfer.empty());
}

double error_on(const Case& predicted, const Case& measured) {
    double square = 0.0;
    for (std::size_t i = 0; i < measured.records[0].rows(); ++i)
        square += std::pow(predicted.records[0].columns.at("torque_Nm")[i] - measured.records[0].columns.at("torque_Nm")[i], 2);
    return std::sqrt(square / static_cast<double>(measured.records[0].rows()));
}

// The dynamometer's own compliance, once it is told, is no fault of the joint.
TEST(DiagnoseCamJoint, TheDynamometerMayYield) {
    Case subsystem_case = measure(CamRig{.series = 4e-4}, 73);
    subsystem_case.parameters["dynamometer_Nm_per_rad"] = 2500.0;
    EXPECT_EQ(names_of(diagnose(subsystem_case, {.jobs = 1, .progress = {}})), "");
}

class CamFolder : public fixtures::TempFolder {
protected:
    static constexpr const char* kToml = "[bench]\nkind = \"cam_joint\"\n[experiments]\n";
    static constexpr const char* kPull = "t_s,q_rad,torque_Nm\n0,0,0\n1,0.1,5\n2,0.2,9\n";
    [[nodiscard]] std::string field_of(const std::string& toml) const {
        core::write_file(folder_ / "case.toml", kToml + toml);
        return field_refused([&] { return read_case(folder_); });
    }
    void put(const std::string& name, const std::string& text) const { core::write_file(folder_ / name, text); }
};

TEST_F(CamFolder, FindsTheLawOfEachPull) {
    put("pull_a.csv", kPull);
    put("pull_b.csv", std::string("# law=other.csv\n") + kPull);
    put("law_a.csv", "q_rad,torque_Nm\n-0.3,-30\n0.3,30\n");
    put("other.csv", "q_rad,torque_Nm\n-0.3,-60\n0.3,60\n");
    EXPECT_EQ(field_of("pull = [\"pull_a.csv\", \"pull_b.csv\"]\n"), "accepted");
    const Case subsystem_case = read_case(folder_);
    EXPECT_EQ(subsystem_case.records.at(0).law.file, "law_a.csv");
    EXPECT_EQ(subsystem_case.records.at(1).law.torque_Nm.back(), 60.0);
    put("pull_b.csv", kPull);
    EXPECT_EQ(field_of("pull = [\"pull_a.csv\", \"pull_b.csv\"]\nlaw = [\"other.csv\", \"law_a.csv\"]\n"), "accepted");
    EXPECT_EQ(read_case(folder_).records.at(0).law.file, "law_a.csv") << "its name goes before its place";
    EXPECT_EQ(field_of("pull = [\"pull_a.csv\", \"pull_b.csv\"]\nlaw = \"other.csv\"\n"), "accepted");
    EXPECT_EQ(read_case(folder_).records.at(1).law.file, "other.csv");
}

TEST_F(CamFolder, RefusesWithThePlace) {
    put("pull_a.csv", kPull);
    put("pull_b.csv", kPull);
    EXPECT_EQ(field_of("pull = \"pull_a.csv\"\n"), "pull_a.csv: law");
    put("law_a.csv", "q_rad,torque_Nm\n-0.3,-30\n-0.3,30\n");
    EXPECT_NE(field_of("pull = \"pull_a.csv\"\n").find("law_a.csv:3:1: q_rad"), std::string::npos);
    put("law_a.csv", "q_rad,torque_Nm\n-8.6,-30\n8.6,30\n");
    EXPECT_NE(field_of("pull = \"pull_a.csv\"\n").find("law_a.csv:2:1: q_rad"), std::string::npos) << "are these degrees?";
    put("law_a.csv", "q_rad,torque_Nm\n-0.1,-30\n0.1,30\n");
    EXPECT_EQ(field_of("pull = \"pull_a.csv\"\n"), "accepted");
    EXPECT_EQ(field_refused([&] { return diagnose(read_case(folder_)); }), "pull_a.csv: q_rad") << "beyond the law";
    EXPECT_NE(field_of("force_loop = \"pull_a.csv\"\n").find("experiments.force_loop"), std::string::npos);
    put("pull_a.csv", std::string("# law=../x.csv\n") + kPull);
    EXPECT_EQ(field_of("pull = \"pull_a.csv\"\n"), "pull_a.csv: law");
}

// The torque of a file of another cam: from its own law and what the case was found to have; its zero is the mean of the case's.
TEST_F(CamFolder, PredictsAFileOfAnotherCam) {
    const CamRig rig{.scale = -0.22, .coulomb = 1.5};
    const Case subsystem_case = measure(rig, 80);
    const diagnosis::Diagnosis found =
        diagnosis::parse_diagnosis(diagnosis::diagnosis_json(diagnose(subsystem_case, {.jobs = 1, .progress = {}})), "diagnosis.json");
    std::mt19937_64 random(81);
    Case other = subsystem_case;
    other.records = {fixtures::cam_pull(rig, true, 0.0, "new", random)};
    for (double& torque : other.records[0].law.torque_Nm) torque *= 1.5;
    for (double& torque : other.records[0].columns["torque_Nm"]) torque *= 1.5;
    write_rows(other, folder_);
    std::string law = "q_rad,torque_Nm\n";
    for (std::size_t i = 0; i < other.records[0].law.q_rad.size(); ++i)
        law += std::to_string(other.records[0].law.q_rad[i]) + "," + std::to_string(other.records[0].law.torque_Nm[i]) + "\n";
    put("law_new.csv", law);
    const Case inputs = read_inputs(subsystem_case, folder_);
    ASSERT_EQ(inputs.records.size(), 1u);
    EXPECT_LT(error_on(predict(subsystem_case, found, inputs), other), 1.0);
    EXPECT_GT(error_on(predict(subsystem_case, {}, inputs), other), 5.0);
}

// Measured by others; the figures are those of docs/subsystem-cases.md.
TEST_F(CamFolder, DesrCamsHaveAnotherRateAndNoCompliance) {
    const fs::path files = fixtures::real_measurements("cam_joint_desr");
    if (!fs::exists(files)) GTEST_SKIP() << files << " does not exist";
    for (const fs::directory_entry& e : fs::directory_iterator(files)) fs::create_symlink(e.path(), folder_ / e.path().filename());
    ASSERT_EQ(field_of("pull = [\"pull_plantar.csv\", \"pull_dorsal.csv\"]\n"), "accepted");
    const diagnosis::Diagnosis d = diagnose(read_case(folder_), {.jobs = 1, .progress = {}});
    EXPECT_NE(names_of(d).find("law.scale"), std::string::npos) << names_of(d);
    EXPECT_EQ(names_of(d).find("law.series"), std::string::npos) << names_of(d);
    EXPECT_EQ(names_of(d).find("law.preload"), std::string::npos) << names_of(d);
    EXPECT_TRUE(says(d, "law.series is a false cause"));
    EXPECT_TRUE(says(d, "law.preload is a false cause"));
    EXPECT_TRUE(says(d, "what remains: "));
    const diagnosis::Transfer plantar = transfer_to(d, "law.scale", "pull_plantar.csv"),
                              dorsal = transfer_to(d, "law.scale", "pull_dorsal.csv");
    EXPECT_NEAR(plantar.heldout_before, 10.4, 0.1);
    EXPECT_NEAR(plantar.heldout_after, 4.6, 0.3);
    EXPECT_NEAR(dorsal.heldout_before, 6.9, 0.1);
    EXPECT_NEAR(dorsal.heldout_after, 3.5, 0.3);
    EXPECT_GT(transfer_to(d, "law.series", "pull_dorsal.csv").heldout_after, 1.1 * dorsal.heldout_before);
    EXPECT_GT(transfer_to(d, "law.preload", "pull_dorsal.csv").heldout_after, 1.1 * dorsal.heldout_before);
}

}  // namespace
}  // namespace fusee::subsystem
