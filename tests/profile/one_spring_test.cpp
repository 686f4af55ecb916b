#include "fixture.h"
#include "fusee/core/units.h"
#include "fusee/profile/edit.h"

namespace fusee::profile {
namespace {

constexpr const char* kOne = R"(name = "one"
kind = "spring"
[law]
kind = "constant"
torque_Nm = 0.5
from_deg = -10.0
to_deg = 90.0
[cable]
diameter_mm = 0.8
[process]
kind = "fdm"
[cam]
family = "cable"
[cam.spring]
rate_N_per_m = 5000.0
preload_mm = 10.0
[cam.hub]
bore_mm = 6.0
)";

class OneSpringProfile : public ProfileTest {
protected:
    static std::string with(const std::string& from, const std::string& to) {
        std::string text = kOne;
        const auto at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    }
    const OneSpring& law_of(const std::string& toml) {
        profile_ = read(toml);
        return std::get<OneSpring>(profile_.law.curves);
    }
    void expect_refusal(const std::string& toml, std::initializer_list<const char*> words) {
        const std::string text = refusal(toml);
        for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
    }
    Profile profile_;
};

TEST_F(OneSpringProfile, HasOnePartAndNoRig) {
    const OneSpring& law = law_of(kOne);
    EXPECT_EQ(law.kind, OneSpring::Kind::kConstant);
    EXPECT_DOUBLE_EQ(law.angles.low, core::rad_from_deg(-10.0));
    EXPECT_TRUE(profile_.has_parts);
    ASSERT_EQ(profile_.part_kinds().size(), 1U);
    EXPECT_EQ(profile_.part_kinds().front(), cam::PartKind::kParallel);
    EXPECT_EQ(profile_.k_pe.spring.rate, 5000.0);
    EXPECT_EQ(profile_.table_of(cam::PartKind::kParallel), "cam");
    EXPECT_FALSE(profile_.outputs.pair);
}

TEST_F(OneSpringProfile, IsWrittenAndReadAgain) {
    for (const std::string& toml :
         {with("kind = \"constant\"\ntorque_Nm = 0.5", "kind = \"gravity\"\nmass_kg = 2.0\nlever_mm = 100.0"),
          with("kind = \"constant\"\ntorque_Nm = 0.5", "kind = \"exponential\"\nscale_Nm = 0.3\nrate_per_rad = -2.0\noffset_Nm = 1.0"),
          with("kind = \"constant\"\ntorque_Nm = 0.5", "kind = \"stiffness\"\nstiffness_Nm_per_rad = \"1+x^2\"\nfirst_torque_Nm = 0.1"),
          with("kind = \"constant\"\ntorque_Nm = 0.5\nfrom_deg = -10.0\nto_deg = 90.0",
               "kind = \"points\"\nangles_deg = [0.0, 10.0, 20.0, 30.0]\ntorques_Nm = [0.1, -0.2, 0.3, 0.4]"),
          with("family = \"cable\"",
               "family = \"roller\"\n[cam.roller]\nfollower = \"arm\"\narm_mm = 60.0\npivot_mm = 72.0\nside = -1\n"
               "lever_mm = 50.0\nspring_mm = 61.0"),
          with("family = \"cable\"", "family = \"two_cables\"\nleast_torque_Nm = 0.3\n[cam.back]\npreload_mm = 12.0\nturned_deg = 180.0"),
          with("family = \"cable\"\n[cam.spring]\nrate_N_per_m = 5000.0\npreload_mm = 10.0",
               "family = \"spool\"\npulley_radius_mm = 30.0\n[cam.spring]\nrate_Nm_per_rad = 0.02\npreload_rad = 4.0")}) {
        const std::string once = to_toml(read(toml));
        EXPECT_EQ(to_toml(read(once)), once);
        EXPECT_NE(once.find("[cam.spring]"), std::string::npos);
        for (const char* table : {"[rig]", "[k_se", "[k_pe"}) EXPECT_EQ(once.find(table), std::string::npos) << table;
        EXPECT_EQ(to_toml(read(to_commented_toml(read(toml)))), once);
    }
}

TEST_F(OneSpringProfile, ComparesAnUnknownKeyWithItsOwnKeysAlone) {
    expect_refusal(with("rate_N_per_m = 5000.0", "rat_N_per_m = 5000.0"),
                   {"cam.spring.rat_N_per_m", "nearest known one: cam.spring.rate_N_per_m"});
    expect_refusal(with("[cam.spring]", "[k_pe.sprin]"), {"nearest known one: [cam.spring]"});
    expect_refusal(with("from_deg", "frm_deg"), {"nearest known one: law.from_deg"});
}

TEST_F(OneSpringProfile, OfARollerNeedsNoCable) {
    const std::string roller = with("family = \"cable\"", "family = \"roller\"");
    EXPECT_EQ(refusal(roller), "");
    std::string bare = roller;
    bare.replace(bare.find("[cable]\ndiameter_mm = 0.8\n"), 26, "");
    EXPECT_EQ(refusal(bare), "");
    expect_refusal(bare.replace(bare.find("\"roller\""), 8, "\"cable\""), {"cable.diameter_mm: missing"});
}

TEST_F(OneSpringProfile, OfTwoCablesHasALeastTorqueAndAWayBack) {
    const std::string two = with("family = \"cable\"", "family = \"two_cables\"\nleast_torque_Nm = 0.3");
    const OneSpring& law = law_of(two);
    EXPECT_EQ(law.two_cables.least_torque, 0.3);
    EXPECT_TRUE(profile_.has_two_cables());
    EXPECT_EQ(profile_.k_pe.cam.family, cam::Family::kCable);
    expect_refusal(with("\"cable\"", "\"two_cables\""), {"cam.least_torque_Nm: missing"});
    expect_refusal(kOne + std::string("[cam.back]\npreload_mm = 12.0\n"), {"cam.back.preload_mm", "only with cam.family = \"two_cables\""});
}

TEST_F(OneSpringProfile, ReadsATableInTheUnitsOfItsHeader) {
    std::string csv = "angle [deg],torque [mNm]\n";
    for (int i = 0; i < 9; ++i) csv += std::to_string(10 * i) + "," + std::to_string(100 - 25 * i) + "\n";
    core::write_file(folder_ / "law.csv", csv);
    const std::string toml =
        with("kind = \"constant\"\ntorque_Nm = 0.5\nfrom_deg = -10.0\nto_deg = 90.0", "kind = \"table\"\nfile = \"law.csv\"");
    const OneSpring& law = law_of(toml);
    ASSERT_EQ(law.rows.x.size(), 9U);
    EXPECT_NEAR(law.rows.x.back(), core::rad_from_deg(80.0), 1e-12);
    EXPECT_NEAR(law.rows.y.back(), -0.1, 1e-12);  // a torque that changes its sign is data
}

/// `law.file` is a key of either kind of profile: an edit takes that of the profile's.
TEST_F(OneSpringProfile, IsEditedByItsOwnKeys) {
    core::write_file(folder_ / "law.csv", "angle_rad,torque_Nm\n0,1\n1,2\n2,3\n3,4\n4,5\n5,6\n6,7\n7,8\n");
    const Profile one =
        read(with("kind = \"constant\"\ntorque_Nm = 0.5\nfrom_deg = -10.0\nto_deg = 90.0", "kind = \"table\"\nfile = \"law.csv\""));
    const std::vector<Edit> edits = file_edits(one, folder_ / "beside");
    ASSERT_EQ(edits.size(), 1U);
    EXPECT_EQ(edits.front().key, "law.file");
    EXPECT_EQ(edits.front().value, "\"../law.csv\"");
    EXPECT_EQ(value_text(one, "law.file"), "\"law.csv\"");
}

TEST_F(OneSpringProfile, RefusesWhatAJointHas) {
    expect_refusal(std::string(kOne) + "[rig]\ncapstan_radius_mm = 30.0\n", {"rig.capstan_radius_mm", "only with kind = \"joint\""});
    expect_refusal(std::string(kOne) + "[k_pe]\ntorque_sign = 1\n",
                   {"k_pe.torque_sign", "only with kind = \"joint\"; here: cam.torque_sign"});
    expect_refusal(with("kind = \"spring\"\n", ""), {"cam.family", "only with kind = \"spring\""});
    expect_refusal(with("kind = \"spring\"", "kind = \"springs\""), {"p.toml:2:8: kind", "\"joint\" or \"spring\""});
}

TEST_F(OneSpringProfile, RefusesAnImpossibleLaw) {
    expect_refusal(with("\"constant\"", "\"from_dead_band\""), {"law.kind", "\"gravity\""});
    expect_refusal(with("to_deg = 90.0", "to_deg = -20.0"), {"law.to_deg", "above law.from_deg = -10 deg"});
    expect_refusal(with("torque_Nm = 0.5", "torque_Nm = 0.0"), {"law.torque_Nm", "another number than 0"});
    expect_refusal(with("to_deg = 90.0\n", ""), {"law.to_deg", "missing"});
    expect_refusal(with("torque_Nm = 0.5", "mass_kg = 1.0"),
                   {"law.mass_kg", "only with law.kind = \"gravity\"", "law.torque_Nm", "missing"});
    expect_refusal(with("kind = \"constant\"\ntorque_Nm = 0.5\nfrom_deg = -10.0\nto_deg = 90.0",
                        "kind = \"points\"\nangles_deg = [0.0, 10.0, 10.0, 30.0]\ntorques_Nm = [0.1, 0.2, 0.3]"),
                   {"law.angles_deg", "above the angle before, 10 deg", "law.torques_Nm"});
}

TEST_F(OneSpringProfile, HasTheKeysOfItsFamilyOnly) {
    expect_refusal(with("rate_N_per_m = 5000.0", "rate_Nm_per_rad = 0.02"), {"cam.spring.rate_Nm_per_rad", "cam.family = \"spool\""});
    expect_refusal(with("family = \"cable\"", "family = \"cable\"\npulley_radius_mm = 30.0"), {"cam.pulley_radius_mm", "\"spool\""});
    expect_refusal(with("[cam.hub]", "[cam.roller]\nradius_mm = 5.0\n[cam.hub]"), {"cam.roller.radius_mm", "cam.family = \"roller\""});
}

}  // namespace
}  // namespace fusee::profile
