#include "profile/fixture.h"

namespace fusee::profile {
namespace {

using RefusalTest = ProfileTest;

TEST_F(RefusalTest, UnknownKeyNamesFileLineColumnAndTheNearest) {
    expect_words(refusal(edited("gear_friction", "gear_fricton")), {"p.toml:5:1: rig.gear_fricton", "unknown key", "rig.gear_friction"});
    expect_words(refusal(edited("[k_pe.spring]", "[k_ep.spring]")), {"p.toml:24:", "k_ep", "unknown table", "[k_pe]"});
    expect_words(refusal("\"rig.gear_friction\" = 0.1\n" + std::string(kShort)), {"p.toml:1:1: rig.gear_friction", "unknown key"});
    expect_words(refusal(std::string(kShort) + "[compensation]\nshrink = 0.5\n"), {"p.toml:28:1", "compensation.shrink_x_percent"});
    expect_words(refusal(std::string(kShort) + "[k_pe.gide]\nz_mm = 1\n"), {"p.toml:27:", "unknown table", "[k_pe.guide]"});
}

TEST_F(RefusalTest, AChoiceThatNeedsOtherKeysNamesThemAndItsLine) {
    const std::string text = std::string(kShort) + "[k_pe.hub]\nkind = \"overhung\"\n";
    expect_words(refusal(text),
                 {"p.toml:28:8: k_pe.hub.boss_mm and k_pe.hub.boss_height_mm: missing, or 0", "with k_pe.hub.kind = \"overhung\""});
    expect_words(refusal(text + "boss_mm = 16\n"), {"p.toml:28:8: k_pe.hub.boss_height_mm: missing"});
    EXPECT_EQ(refusal(text + "boss_mm = 16\nboss_height_mm = 8\n"), "");
    // The lead is left out: its table says where.
    expect_words(refusal(std::string(kShort) + "[k_se.path]\nkind = \"helix\"\n"), {"p.toml:27:", "k_se.path.pitch_mm: missing"});
}

TEST_F(RefusalTest, WrongUnitNamesTheRightOne) {
    expect_words(refusal(edited("diameter_mm = 0.8", "diameter_m = 0.0008")), {"p.toml:18:1: cable.diameter_m", "cable.diameter_mm"});
    expect_words(refusal(edited("lead_in_deg = 5", "lead_in_rad = 0.1")), {"p.toml:16:1: law.lead_in_rad", "law.lead_in_deg"});
    expect_words(refusal(edited("rate_N_per_m = 7460", "rate_N_per_mm = 7.46")), {"k_pe.spring.rate_N_per_m,"});
}

TEST_F(RefusalTest, WrongTypeNotANumberAndOutOfRange) {
    expect_words(refusal(edited("gear_friction = 0.28", "gear_friction = \"0.28\"")), {"p.toml:5:17: rig.gear_friction", "0 to 0.95"});
    expect_words(refusal(edited("gear_friction = 0.28", "gear_friction = nan")), {"p.toml:5:17: rig.gear_friction", "nan", "0 to 0.95"});
    expect_words(refusal(edited("gear_friction = 0.28", "gear_friction = 0.99")), {"rig.gear_friction: 0.99 (allowed"});
    expect_words(refusal(edited("gear_friction = 0.28", "gear_friction = true")), {"p.toml:5:17: rig.gear_friction", "true"});
    expect_words(refusal(edited("u_Nm = 0.0012", "u_Nm = inf")), {"p.toml:12:8: law.u_Nm", "inf"});
    expect_words(refusal(edited("joint_radius_mm = 25", "joint_radius_mm = 0")), {"p.toml:4:19: rig.joint_radius_mm", "above 0", "mm"});
    expect_words(refusal(edited("kind = \"fdm\"", "kind = \"FDM\"")), {"p.toml:20:8: process.kind", "\"fdm\" or \"sla\""});
    expect_words(refusal(edited("kind = \"fdm\"", "kind = \"fdm\"\nbuild_mm = [200, 200]")), {"p.toml:21:", "array of 3 numbers"});
    expect_words(refusal(edited("name = \"short\"", "name = \"../short\"")), {"p.toml:1:8: name", "letters"});
    expect_words(refusal(std::string(kShort) + "[outputs]\nsprings_rows = 199\n"), {"p.toml:28:16: outputs.springs_rows", "200 to"});
    expect_words(refusal(std::string(kShort) + "[outputs]\nformats = [\"stl\", \"stl\"]\n"), {"p.toml:28:", "different"});
    expect_words(refusal(std::string(kShort) + "[k_se]\ntorque_sign = 2\n"), {"k_se.torque_sign", "1 or -1"});
    expect_words(refusal(edited("[cable]\n", "cable = 3\n")), {"p.toml:17:1: law.cable"});
    expect_words(refusal("rig = 3\n" + edited("[rig]\n", "[law.rig]\n")), {"p.toml"});
}

// Each of these would make a rule pass that needs the figure: fatigue, surge, buckling, walls, bend, ranges, stress, contact.
TEST_F(RefusalTest, AnAbsurdFigureIsRefusedBeforeARuleTakesIt) {
    const auto in = [this](const std::string& table, const std::string& line) {
        return refusal(edited("[" + table + "]\n", "[" + table + "]\n" + line + "\n"));
    };
    for (const char* value : {"1e-9", "-1", "1e300", "0.0001", "-0.5"}) {
        for (const char* key : {"cycles", "motion_Hz", "free_length_mm", "rod_mm", "wire_mm", "coil_mm", "active_coils"})
            expect_words(in("k_pe.spring", std::string(key) + " = " + value), {"p.toml:25:", key, " to "});
        for (const char* key : {"min_wall_mm", "min_hole_mm", "cutter_radius_mm", "layer_mm", "tolerance_mm", "max_overhang_deg"})
            expect_words(in("process", std::string(key) + " = " + value), {"p.toml:20:", key, "0, or "});
        for (const char* key : {"min_bend_ratio", "breaking_load_N", "max_pressure_MPa", "max_fleet_deg"})
            expect_words(in("cable", std::string(key) + " = " + value), {"p.toml:18:", key, "0, or "});
    }
    expect_words(in("k_pe.spring", "tensile_strength_MPa = 9999"), {"k_pe.spring.tensile_strength_MPa", "0, or 100 to 5000 MPa"});
    EXPECT_EQ(in("k_pe.spring", "cycles = 1"), "");
    EXPECT_EQ(in("process", "min_wall_mm = 0"), "");
}

TEST_F(RefusalTest, ATextOfATitleBlockIsOneLineOfLimitedLength) {
    const auto owner = [this](const std::string& text) { return refusal(std::string(kShort) + "[drawing]\nowner = \"" + text + "\"\n"); };
    EXPECT_EQ(owner(std::string(39, 'a') + "\u00e4"), "") << "a letter of two bytes counts once";
    EXPECT_EQ(owner(""), "");
    expect_words(owner(std::string(41, 'a')), {"p.toml:28:9: drawing.owner", "one line", "at most 40 letters"});
    expect_words(owner("two\\nlines"), {"p.toml:28:9: drawing.owner", "one line"});
    expect_words(refusal(std::string(kShort) + "[drawing]\nnumber = 4711\n"), {"p.toml:28:10: drawing.number", "a text"});
}

TEST_F(RefusalTest, MissingKeyAndMissingTable) {
    expect_words(refusal(edited("c_Nm = 0.265\n", "")), {"p.toml:9:1: law.c_Nm: missing", "a number"});
    expect_words(refusal(edited("[k_pe.spring]\nrate_N_per_m = 7460\npreload_mm = 14.6\n", "")), {"k_pe.spring.rate_N_per_m: missing"});
    expect_words(refusal(""), {"p.toml:1:1: name: missing"});
    expect_words(refusal(std::string(kShort) + "[k_pe.guide]\nkind = \"point\"\n"), {"k_pe.guide.distance_mm: missing"});
}

TEST_F(RefusalTest, KeyThatTheChosenKindDoesNotUse) {
    expect_words(refusal(edited("c_Nm = 0.265", "c_Nm = 0.265\nseries_Nm = [1, 2]")),
                 {"p.toml:14:", "law.series_Nm", "only with law.kind = \"polynomial\""});
}

TEST_F(RefusalTest, FiguresOutOfOrder) {
    expect_words(refusal(edited("least_torque_Nm = 0.78", "least_torque_Nm = 1.0")),
                 {"rig.peak_torque_Nm", "above rig.least_torque_Nm = 1 Nm"});
    expect_words(refusal(edited("end_torque_Nm = 2.09", "end_torque_Nm = 0.5")),
                 {"p.toml:15:", "law.end_torque_Nm", "law.start_torque_Nm = 0.6"});
    EXPECT_EQ(refusal(edited("overdrive_torque_Nm = 1.5", "overdrive_torque_Nm = 1")), "");
}

TEST_F(RefusalTest, BadTomlNamesLineAndColumn) {
    expect_words(refusal(edited("gear_friction = 0.28", "gear_friction = = 0.28")), {"p.toml:5:17", "not valid TOML"});
    expect_words(refusal(edited("c_Nm = 0.265", "c_Nm = 0.265\nc_Nm = 0.3")), {"p.toml:14:", "not valid TOML"});
}

TEST_F(RefusalTest, ForeignCharactersOutsideOfTextsAreFoundBeforeTheParserMeetsThem) {
    expect_words(refusal("\xCD\x83"), {"p.toml:1:1", "outside ASCII"});
    expect_words(refusal(edited("u_Nm", "\xC2\xB5_Nm")), {"p.toml:12:1", "outside ASCII"});
    expect_words(refusal("a = \"\\\"\" \xC3\xA4\n"), {"p.toml:1:10", "outside ASCII"});
    expect_words(refusal("a = '''\n\xC3\xA4 '' ''' \xC3\xA4\n"), {"p.toml:2:11", "outside ASCII"});
    expect_words(refusal(edited("short", "sh\xC3\xB6rt")), {"p.toml:1:8: name", "letters"});  // in a text it is TOML, but no name
}

TEST_F(RefusalTest, MissingAndOversizedFile) {
    EXPECT_THROW((void)read_profile(folder_ / "none.toml"), core::IoError);
    EXPECT_THROW((void)read_profile(folder_), core::IoError);
    expect_words(refusal(std::string(kLargestFile + 1, '#')), {"p.toml", "10000000 bytes"});
    expect_words(refusal(edited("kind = \"stiction_compensating\"\nk_per_Nm_rad = 0.225\nu_Nm = 0.0012\nc_Nm = 0.265\n",
                                "kind = \"table\"\nfile = \"none.csv\"\n")),
                 {"none.csv"});
}

}  // namespace
}  // namespace fusee::profile
