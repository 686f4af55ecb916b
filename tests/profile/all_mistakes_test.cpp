#include <algorithm>

#include "profile/fixture.h"

// All mistakes of a profile are reported in one run, in the order of its lines; consequences of others are not.
namespace fusee::profile {
namespace {

class AllMistakesTest : public ProfileTest {
protected:
    /// Number of reported mistakes: one line each, below a heading if there are several.
    static std::size_t count(const std::string& text) {
        const auto ends = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
        return text.empty() ? 0 : std::max<std::size_t>(ends, 1);
    }
    static std::string without(std::string text, std::initializer_list<const char*> lines) {
        for (const std::string line : lines) {
            const auto at = text.find("\n" + line + " =");
            EXPECT_NE(at, std::string::npos) << line;
            text.erase(at + 1, text.find('\n', at + 1) - at);
        }
        return text;
    }
};

TEST_F(AllMistakesTest, ThirteenMissingKeys) {
    const std::string text =
        refusal(without("\n" + std::string(kShort),
                        {"name", "capstan_radius_mm", "joint_radius_mm", "gear_friction", "least_torque_Nm", "peak_torque_Nm",
                         "k_per_Nm_rad", "u_Nm", "start_torque_Nm", "diameter_mm", "rate_Nm_per_rad", "preload_rad", "preload_mm"}));
    EXPECT_EQ(count(text), 13u) << text;
    expect_words(text, {"p.toml:1:1: name: missing", "p.toml:2:1: rig.capstan_radius_mm: missing", "rig.joint_radius_mm: missing",
                        "rig.gear_friction: missing", "rig.least_torque_Nm: missing", "rig.peak_torque_Nm: missing",
                        "p.toml:4:1: law.k_per_Nm_rad: missing", "law.u_Nm: missing", "law.start_torque_Nm: missing",
                        "p.toml:9:1: cable.diameter_mm: missing", "p.toml:12:1: k_se.spring.rate_Nm_per_rad: missing",
                        "k_se.spring.preload_rad: missing", "p.toml:13:1: k_pe.spring.preload_mm: missing"});
}

TEST_F(AllMistakesTest, OfEveryKindInTheOrderOfTheLines) {
    std::string text = edited("capstan_radius_mm = 30", "capstan_radius_mm = -30");
    const auto change = [&text](const std::string& from, const std::string& to) { text.replace(text.find(from), from.size(), to); };
    change("joint_radius_mm = 25", "joint_radius_mm = \"25\"");
    change("overdrive_torque_Nm = 1.5", "overdrive_torque_Nm = 0.9");
    change("u_Nm = 0.0012", "u_Nm = nan");
    change("lead_in_deg = 5", "lead_in_rad = 5\nseries_Nm = [1, 2]");
    change("preload_rad = 3.6\n", "");
    text +=
        "[outputs]\nformats = [\"stl\", \"stl\", \"dwg\"]\n[[limits]]\nrule = \"process.wall\"\nrequired_m = 1\n[[limits]]\nrule = \"x\"\n";
    const std::string message = refusal(text);
    EXPECT_EQ(count(message), 13u) << message;
    std::size_t before = 0;
    for (const char* words :
         {"p.toml:3:21: rig.capstan_radius_mm: -30", "p.toml:4:19: rig.joint_radius_mm: '25'", "p.toml:8:23: rig.overdrive_torque_Nm: 0.9",
          "p.toml:12:8: law.u_Nm: nan", "p.toml:16:1: law.lead_in_rad: unknown key", "p.toml:17:13: law.series_Nm: has no meaning here",
          "p.toml:22:1: k_se.spring.preload_rad: missing", "p.toml:28:19: outputs.formats: 'stl'", "p.toml:28:26: outputs.formats: 'dwg'",
          "p.toml:29:1: limits.reason: missing", "p.toml:31:1: limits.required_m: not the unit", "p.toml:32:1: limits.reason: missing",
          "p.toml:33:8: limits.rule: unknown rule"}) {
        const std::size_t at = message.find(words);
        EXPECT_NE(at, std::string::npos) << words << " in\n" << message;
        EXPECT_GE(at, before) << words;
        before = at;
    }
}

TEST_F(AllMistakesTest, ConsequencesOfAnotherAreNotReported) {
    expect_words(refusal(edited("kind = \"stiction_compensating\"", "kind = \"stiction\"")), {"p.toml:10:8: law.kind"});
    EXPECT_EQ(count(refusal(edited("kind = \"stiction_compensating\"", "kind = \"stiction\""))), 1u)
        << "the keys of a kind that is not known";
    EXPECT_EQ(count(refusal(edited("gear_friction = 0.28", "gear_fricton = 0.28"))), 1u) << "missing, because misspelt";
    EXPECT_EQ(count(refusal(edited("[k_pe.spring]", "[k_pe.sprung]"))), 1u);
    EXPECT_EQ(count(refusal("cable = 3\n" + edited("[cable]\ndiameter_mm = 0.8\n", ""))), 1u);
    EXPECT_EQ(count(refusal(edited("peak_torque_Nm = 1.0", "peak_torque_Nm = \"one\""))), 1u) << "its order with two others";
    EXPECT_EQ(count(refusal(edited("[rig]\n", "[rig]\narrangement = \"bidirectional\"\n"))), 1u) << "every key of a part";
    EXPECT_EQ(count(refusal(edited("[rig]\n", "[rig]\narrangement = \"x\"\n"))), 1u);
}

TEST_F(AllMistakesTest, OfTheFilesThatItNames) {
    core::write_file(folder_ / "measured.csv", "tau_Nm,width_deg\n0.5,-3\n0.4,\n");
    const std::string message = refusal(edited("gear_friction = 0.28", "gear_friction_table = \"none.csv\"") +
                                        "[simulate]\nmeasured = \"measured.csv\"\nlevels = 1\n");
    expect_words(message, {"p.toml:29:10: simulate.levels: 1", "p.toml:5:23: rig.gear_friction_table: \"none.csv\"", "cannot be opened",
                           "measured.csv:3:5: width_deg: (missing)"});
}

TEST_F(AllMistakesTest, ThousandsAreCounted) {
    std::string text = kShort;
    for (int i = 0; i < 100'000; ++i) text += "x" + std::to_string(i) + " = 1\n";
    const std::string message = refusal(text);
    EXPECT_EQ(count(message), 101u);
    EXPECT_TRUE(message.ends_with("p.toml: 99900 more mistakes (allowed: none)")) << message.substr(message.size() - 100);
    EXPECT_LT(refusal(std::string(kShort) + std::string(9'000'000, 'k') + " = 1\n").size(), 1000u);
}

TEST_F(AllMistakesTest, NoFigureSoSmallThatItVanishes) {
    expect_words(
        refusal(edited("joint_radius_mm = 25", "joint_radius_mm = 5e-324")),
        {"p.toml:4:19: rig.joint_radius_mm: 5e-324 (allowed: a number, above 0, at most 1000 mm; not so close to 0: at least 1e-09"});
    expect_words(refusal(edited("u_Nm = 0.0012", "u_Nm = 1e-310")), {"law.u_Nm: 1e-310", "at least 1e-30"});
    expect_words(refusal(edited("c_Nm = 0.265", "c_Nm = -1e-310")), {"law.c_Nm: -1e-310", "at least 1e-30"});
    EXPECT_EQ(refusal(edited("u_Nm = 0.0012", "u_Nm = 0")), "");
    const Profile least = read(edited("joint_radius_mm = 25", "joint_radius_mm = 1e-9"));
    EXPECT_EQ(to_toml(read(to_toml(least))), to_toml(least));
}

}  // namespace
}  // namespace fusee::profile
