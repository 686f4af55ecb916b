#include "profile/fixture.h"

// How far the cables of both cams stretch: E A and their lengths (docs/theory/cams.md, eq. 18).
namespace fusee::profile {
namespace {

class CableKeys : public ProfileTest {
protected:
    [[nodiscard]] static std::string with_cable(const std::string& stiffness, const std::string& series, const std::string& parallel) {
        return edited("[cable]\n", "[cable]\n" + stiffness) + "[k_se]\n" + series + "[k_pe]\n" + parallel;
    }
};

TEST_F(CableKeys, LengthOverStiffnessIsWhatACableGives) {
    const Profile both = read(with_cable("stiffness_N = 25000\n", "cable_length_mm = 300\n", "cable_length_mm = 150\n"));
    EXPECT_DOUBLE_EQ(both.k_se.allowance.cable_compliance, 0.3 / 25000.0);
    EXPECT_DOUBLE_EQ(both.k_pe.allowance.cable_compliance, 0.15 / 25000.0);
    const Profile again = parse_profile(to_toml(both), both.file);
    EXPECT_EQ(again.k_pe.allowance.cable_compliance, both.k_pe.allowance.cable_compliance);
}

TEST_F(CableKeys, WithoutALengthACableIsRigid) {
    const Profile one = read(with_cable("stiffness_N = 25000\n", "", "cable_length_mm = 150\n"));
    EXPECT_EQ(one.k_se.allowance.cable_compliance, 0.0);
    EXPECT_GT(one.k_pe.allowance.cable_compliance, 0.0);
    EXPECT_EQ(read(with_cable("", "cable_length_mm = 0\n", "")).k_se.allowance.cable_compliance, 0.0);
}

TEST_F(CableKeys, ALengthWithoutStiffnessSaysNothing) {
    expect_words(refusal(with_cable("", "", "cable_length_mm = 150\n")), {"p.toml:", "k_pe.cable_length_mm", "cable.stiffness_N above 0"});
    expect_words(refusal(with_cable("stiffness_N = 0\n", "cable_length_mm = 1\n", "")), {"k_se.cable_length_mm", "cable.stiffness_N"});
    expect_words(refusal(with_cable("stiffness_N = 1\n", "cable_length_mm = -1\n", "")), {"k_se.cable_length_mm", "0 to"});
}

TEST_F(CableKeys, ARollerHasNoCable) {
    expect_words(refusal(with_cable("stiffness_N = 25000\n", "", "family = \"roller\"\ncable_length_mm = 150\n")),
                 {"k_pe.cable_length_mm", "has no meaning here"});
}

}  // namespace
}  // namespace fusee::profile
