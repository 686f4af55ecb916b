#include "profile/fixture.h"

namespace fusee::profile {
namespace {

using MachiningKeys = ProfileTest;

TEST_F(MachiningKeys, LeftOutTheyAreTheRoomsAndNoGCodeIsAskedFor) {
    const Profile p = read(kShort);
    EXPECT_FALSE(p.outputs.has("ngc"));
    EXPECT_EQ(p.machining.tool_diameter, toolpath::Settings{}.tool_diameter);
    EXPECT_EQ(p.machining.k_pe, toolpath::Method::kWrap);
}

TEST_F(MachiningKeys, AreReadInMillimetresAndMinutes) {
    const Profile p =
        read(std::string(kShort) +
             "[outputs]\nformats = [\"ngc\"]\n[machining]\ncontroller = \"linuxcnc\"\nk_pe = \"stack\"\ntool_diameter_mm = 2\n"
             "feed_mm_per_min = 240\ntolerance_mm = 0.002\nrotary_sign = -1\n");
    EXPECT_TRUE(p.outputs.has("ngc"));
    EXPECT_FALSE(p.outputs.has("stl"));
    EXPECT_EQ(p.machining.k_pe, toolpath::Method::kStack);
    EXPECT_EQ(p.machining.tool_diameter, 2e-3);
    EXPECT_EQ(p.machining.feed, 4e-3);
    EXPECT_EQ(p.machining.tolerance, 2e-6);
    EXPECT_EQ(p.machining.rotary_sign, -1);
}

TEST_F(MachiningKeys, BadOnesAreRefusedByName) {
    const auto with = [this](const std::string& line) { return refusal(std::string(kShort) + "[machining]\n" + line + "\n"); };
    expect_words(with("tool_diameter_mm = 0"), {"p.toml:28:20: machining.tool_diameter_mm", "0.01 to 100 mm"});
    expect_words(with("feed_mm_per_min = -5"), {"machining.feed_mm_per_min", "mm/min"});
    expect_words(with("safe_height_mm = 0"), {"machining.safe_height_mm", "0.1 to 1000 mm"});
    expect_words(with("tolerance_mm = 0.00001"), {"machining.tolerance_mm", "0.0001 to 0.1"});
    expect_words(with("controller = \"grbl\""), {"machining.controller", "\"linuxcnc\""});
    expect_words(with("k_se = \"lathe\""), {"machining.k_se", "\"stack\" or \"wrap\""});
    expect_words(with("feed_mm_min = 3"), {"machining.feed_mm_min", "unknown key", "machining.feed_mm_per_min"});
}

}  // namespace
}  // namespace fusee::profile
