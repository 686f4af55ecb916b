#include "fusee/plant/case_files.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fusee::plant {
namespace {

const CaseFiles& faultless() {
    static const CaseFiles files = make_case(21, 5, {});
    return files;
}

TEST(CaseFiles, HoldTheFormatsFilesAndColumns) {
    const CaseFiles& files = faultless();
    const CaseFiles headers{
        {"breakaway.csv", "side,direction,motor_torque_Nm,load_torque_Nm\n"},
        {"spring_pull.csv", "spring,side,phase,deflection_rad,torque_Nm\n"},
        {"dead_band.csv", "cocontraction_Nm,repeat,push_torque_Nm,q_low_rad,q_high_rad\n"},
        {"joint_stiffness.csv", "cocontraction_Nm,phase,joint_torque_Nm,q_rad\n"},
        {"cocontraction.csv", "phase,motor_torque_Nm,theta_agonist_rad,theta_antagonist_rad,q_rad\n"},
        {"log.csv",
         "t_s,motor_torque_agonist_Nm,motor_torque_antagonist_Nm,joint_torque_Nm,theta_agonist_rad,theta_antagonist_rad,q_rad\n"}};
    for (const auto& [name, header] : headers)
        for (const std::string& path : {name, "heldout/" + name}) {
            ASSERT_TRUE(files.count(path)) << path;
            EXPECT_EQ(files.at(path).substr(0, header.size()), header);
            for (const char* wrong : {"nan", "inf"}) EXPECT_EQ(files.at(path).find(wrong), std::string::npos) << path;
        }
    EXPECT_EQ(files.size(), 2 * headers.size() + 2);
    const std::string& springs = files.at("nominal_springs.csv");
    EXPECT_EQ(springs.substr(0, springs.find('\n', 42)), "deflection_rad,se_torque_Nm,pe_torque_Nm\n0,0,0");
    EXPECT_EQ(std::count(springs.begin(), springs.end(), '\n'), 202);
    for (const char* key : {"[rig]", "[tolerance]", "[sensors]", "[protocol]", "[experiments]", "\ngear_load_friction = 0.02\n"})
        EXPECT_NE(files.at("case.toml").find(key), std::string::npos) << key;
}

TEST(CaseFiles, FollowFromSeedAndIndexAlone) {
    EXPECT_EQ(make_case(21, 5, {}), faultless());
    const std::string rig = case_toml(draw_test_rig(21, 5));
    EXPECT_NE(rig, case_toml(draw_test_rig(21, 6)));
    EXPECT_NE(rig, case_toml(draw_test_rig(22, 5)));
}

// What the model is told does not tell what was built in.
TEST(CaseFiles, TheNominalRigDoesNotShowTheEffect) {
    const CaseFiles faulty = make_case(21, 5, {{"se.rate", "both", 0.1, {}}});
    for (const char* name : {"case.toml", "nominal_springs.csv"}) EXPECT_EQ(faultless().at(name), faulty.at(name));
    EXPECT_NE(faultless().at("spring_pull.csv"), faulty.at("spring_pull.csv"));
    EXPECT_EQ(faultless().at("breakaway.csv"), faulty.at("breakaway.csv"));  // the same noise, and no spring in it
}

TEST(CaseFiles, ConditionsChangeTheMeasurementsNotWhatIsStated) {
    const CaseFiles noisy = make_case(21, 5, {}, {}, {.linear_springs = false, .noise = 3.0, .experiments = {}});
    EXPECT_EQ(noisy.at("case.toml"), faultless().at("case.toml"));
    EXPECT_NE(noisy.at("log.csv"), faultless().at("log.csv"));
    const CaseFiles few = make_case(21, 5, {}, {}, {.linear_springs = false, .noise = 1.0, .experiments = {"log", "breakaway"}});
    EXPECT_EQ(few.size(), 2U + 2U + 6U) << "all are held out";
    EXPECT_EQ(few.at("log.csv"), faultless().at("log.csv"));
    EXPECT_NE(few.at("case.toml").find("breakaway = \"breakaway.csv\"\nlog = "), std::string::npos);
    EXPECT_EQ(few.at("case.toml").find("dead_band = "), std::string::npos);
}

TEST(CaseFiles, LinearSpringsAreProportionalToTheDeflection) {
    const SpringCurves& springs = draw_test_rig(21, 5, true).nominal.springs;
    for (std::size_t i = 1; i < springs.deflection.size(); ++i) {
        EXPECT_NEAR(springs.se[i] / springs.deflection[i], springs.se.back() / springs.deflection.back(), 1e-9);
        EXPECT_NEAR(springs.pe[i] / springs.deflection[i], springs.pe.back() / springs.deflection.back(), 1e-9);
    }
}

}  // namespace
}  // namespace fusee::plant
