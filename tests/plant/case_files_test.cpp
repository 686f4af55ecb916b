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

}  // namespace
}  // namespace fusee::plant
