#include "app/run.h"

// Refusal: a malformed profile ends with 2 and names file, line and key; nothing is written.
namespace fusee::app {
namespace {

class BadInput : public Program {
protected:
    std::string text_ = core::read_file(fixtures::shipped("measured_table"));
    std::string csv_ = core::read_file(fixtures::shipped("measured_table").replace_extension(".csv"));

    void expect_refused(const std::string& file, std::initializer_list<std::string> words) const {
        const Ended refused = run("make " + file);
        EXPECT_EQ(refused.code, 2) << refused.all();
        EXPECT_EQ(refused.out, "");
        expect_words(refused.err, words);
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    }
    void expect_key_refused(const std::string& key, const std::string& value, std::initializer_list<std::string> words) const {
        write("measured_table.csv", csv_);
        write("t.toml", fixtures::with_key(text_, key, value));
        SCOPED_TRACE(key + " = " + value);
        expect_refused("t.toml", words);
    }
};

TEST_F(BadInput, NoSuchFile) {
    expect_refused("missing.toml", {"missing.toml"});
    expect_refused("''", {"cannot be opened"});
    expect_refused("\"$(printf 'a%.0s' $(seq 5000))\"", {"aaaa"});
    fs::create_symlink("loop.toml", folder_ / "loop.toml");
    expect_refused("loop.toml", {"loop.toml"});
    fs::create_directories(folder_ / "empty");
    expect_refused("empty", {"empty", "holds no profile"});
}

TEST_F(BadInput, NoToml) {
    write("t.toml", "name = \"x\"\n[rig\ngear_friction = 0.2\n");
    expect_refused("t.toml", {"t.toml:2:", "not valid TOML"});
    write("t.toml", "name = \"\xff\xfe\"\n");
    expect_refused("t.toml", {"t.toml:1:", "utf-8"});
    write("t.toml", std::string("\xff\xfen\0a\0", 6));
    expect_refused("t.toml", {"t.toml:1:1"});
    write("t.toml", "");
    expect_refused("t.toml", {"t.toml:1:1: name: missing"});
    write("t.toml", std::string(20'000'000, '#'));
    expect_refused("t.toml", {"t.toml", "10000000"});
    expect_refused("/dev/zero", {"/dev/zero", "only regular files"});
    write("t.toml", std::string(100'000, '['));
    expect_refused("t.toml", {"t.toml:1:"});
}

TEST_F(BadInput, WrongKeysAndValues) {
    expect_key_refused("rig.gear_frictoin", "0.2", {"t.toml:", "rig.gear_frictoin: unknown key", "rig.gear_friction"});
    expect_key_refused("cable.diameter_cm", "0.08", {"cable.diameter_cm: unknown key", "cable.diameter_mm"});
    expect_key_refused("cabel.diameter_mm", "0.8", {"cabel", "unknown table", "[cable]"});
    expect_key_refused("rig.gear_friction", "nan", {"t.toml:", "rig.gear_friction: nan"});
    expect_key_refused("rig.gear_friction", "inf", {"t.toml:", "rig.gear_friction: inf"});
    expect_key_refused("rig.gear_friction", "\"0.2\"", {"t.toml:", "rig.gear_friction", "a number"});
    expect_key_refused("rig.gear_friction", "1e999", {"t.toml:"});
    expect_key_refused("cable.diameter_mm", "-0.8", {"t.toml:", "cable.diameter_mm: -0.8"});
    expect_key_refused("rig.peak_torque_Nm", "0.1", {"t.toml:", "rig.peak_torque_Nm", "rig.least_torque_Nm"});
    expect_key_refused("outputs.springs_rows", "100", {"t.toml:", "outputs.springs_rows: 100"});
    expect_key_refused("k_se.target_rows", "100000", {"t.toml:", "k_se.target_rows", "200 to 10000"});
    expect_key_refused("law.u_Nm", "0.1", {"t.toml:", "law.u_Nm", "stiction_compensating"});
    for (const char* name : {"\"../up\"", "\"a/b\"", "\"\"", "\".hidden\"", "\"a b\"", "\"\u00e4\""})
        expect_key_refused("name", name, {"t.toml:", "name: "});
}

// The key's place is known where the profile is read, its fault only where the part is built.
TEST_F(BadInput, WhatDoesNotFitTogether) {
    expect_key_refused("k_se.hub.key_width_mm", "8.0", {"t.toml:", "k_se.hub.key_width_mm: 8", "mm"});
    expect_key_refused("k_pe.path.kind", "\"helix\"", {"t.toml:", "k_pe.path.pitch_mm: missing", "k_pe.path.lead = \"constant_pitch\""});
    expect_key_refused("k_pe.features.mark_depth_mm", "50.0", {"t.toml:", "k_pe.features.mark_depth_mm: 50"});
    expect_key_refused("groove.depth_ratio", "0.1", {"t.toml:", "groove.depth_ratio: 0.1"});
    expect_key_refused("k_se.hub.kind", "\"overhung\"",
                       {"t.toml:", "k_se.hub.boss_mm and k_se.hub.boss_height_mm: missing", "k_se.hub.kind = \"overhung\""});
}

TEST_F(BadInput, TablesWithFaults) {
    write("t.toml", text_);
    expect_refused("t.toml", {"measured_table.csv", "cannot be opened"});
    const auto expect_row_refused = [&](const std::string& row, std::initializer_list<std::string> words) {
        std::string rows = "angle_rad,series_Nm,parallel_Nm\n";
        for (int i = 0; i < 10; ++i)
            rows += i == 4 ? row + "\n" : std::to_string(i) + ",0." + std::to_string(i) + ",0." + std::to_string(i) + "\n";
        write("measured_table.csv", rows);
        SCOPED_TRACE(row);
        expect_refused("t.toml", words);
    };
    expect_row_refused("4,,0.4", {"measured_table.csv:6", "series_Nm"});
    expect_row_refused("4,0.4", {"measured_table.csv:6"});
    expect_row_refused("4,0.4,nan", {"measured_table.csv:6", "parallel_Nm"});
    expect_row_refused("4,0.4,0.4,0.4", {"measured_table.csv:6"});
    expect_row_refused("3,0.4,0.4", {"measured_table.csv:6", "angle_rad"});
    expect_row_refused("four,0.4,0.4", {"measured_table.csv:6", "four"});
    write("measured_table.csv", "winkel,series_Nm,parallel_Nm\n");
    expect_refused("t.toml", {"measured_table.csv:1", "angle_rad"});
    write("measured_table.csv", "angle_deg,series_Nm,parallel_Nm\n");  // another unit is converted
    expect_refused("t.toml", {"measured_table.csv:1", "rows: 0"});
    write("measured_table.csv", "");
    expect_refused("t.toml", {"measured_table.csv"});
}

TEST_F(BadInput, AllMistakesAtOnce) {
    std::string empty = "name = \"t\"\n[rig]\n[law]\nkind = \"stiction_compensating\"\n[k_se.spring]\n[k_pe.spring]\n";
    write("t.toml", empty + "rate_N_per_m = -1\n");
    expect_refused("t.toml", {"t.toml:2:1: rig.capstan_radius_mm: missing", "rig.joint_radius_mm: missing", "rig.gear_friction: missing",
                              "rig.least_torque_Nm: missing", "rig.peak_torque_Nm: missing", "rig.overdrive_torque_Nm: missing",
                              "t.toml:3:1: law.k_per_Nm_rad: missing", "law.u_Nm: missing", "law.c_Nm: missing",
                              "law.start_torque_Nm: missing", "law.end_torque_Nm: missing", "t.toml:7:16: k_pe.spring.rate_N_per_m: -1"});
    const Ended checked = run("check t.toml");
    EXPECT_EQ(checked.code, 2);
    expect_words(checked.err, {"fusee: 17 mistakes:\nt.toml:1:1: cable.diameter_mm: missing"});
}

TEST_F(BadInput, NothingThatATerminalObeysIsPrinted) {
    write("t.toml", "name = \"\\u001b]0;x\"\n");
    write("u.toml", "name = \"t\"\n\"\\u001b[2J\" = 1\n");
    write("v.toml", "[law]\nkind = \"from_dead_band\"\ndead_band_deg = \"tau\\u0000\"\n");
    fs::rename(write("s.toml", "name = 3\n"), folder_ / "\x1b[2J.toml");  // fusee writes no such name itself
    write("\xff.toml", "name = 3\n");
    for (const char* file : {"t.toml", "u.toml", "v.toml", "'\x1b[2J.toml'", "'\xff.toml'"}) {
        for (const char* command : {"make ", "check "}) {
            const Ended refused = run(command + std::string(file));
            EXPECT_EQ(refused.code, 2) << command << file << refused.all();
            EXPECT_EQ(refused.all().find_first_of("\x1b\xff"), std::string::npos) << refused.all();
        }
    }
    write("w.toml", "[rig]\n" + std::string(9'000'000, 'k') + " = 1\n");
    EXPECT_LT(run("make w.toml").err.size(), 20'000u);
}

TEST_F(BadInput, AMeshWhoseNameIsNoUtf8IsJudged) {
    const char* corners[4][3] = {
        {"0 0 0", "0 9 0", "9 0 0"}, {"0 0 0", "9 0 0", "0 0 9"}, {"0 0 0", "0 0 9", "0 9 0"}, {"9 0 0", "0 9 0", "0 0 9"}};
    std::string stl = "solid t\n";
    for (const auto& face : corners) {
        stl += "facet normal 0 0 0\nouter loop\n";
        for (const char* corner : face) stl += "vertex " + std::string(corner) + "\n";
        stl += "endloop\nendfacet\n";
    }
    write("\xff.stl", stl + "endsolid t\n");
    EXPECT_LT(run("check --json --process fdm '\xff.stl'").code, 2);
}

TEST_F(BadInput, APipeAsAFileIsNotWaitedFor) {
    write("t.toml", text_);
    ASSERT_EQ(std::system(("mkfifo '" + (folder_ / "measured_table.csv").string() + "' '" + (folder_ / "p.toml").string() + "'").c_str()),
              0);
    expect_refused("p.toml", {"p.toml", "only regular files"});
    expect_refused("t.toml", {"t.toml:", "law.file", "only regular files"});
}

TEST_F(BadInput, NumbersOfTheCommandLine) {
    const std::string simulate = "simulate '" + fixtures::shipped("pnrvsa").string() + "' --levels ";
    for (const char* wrong : {"2 --push-torque nan", "2 --push-torque inf", "2 --push-torque 0x10", "2 --push-torque 1e400",
                              "2 --push-torque ''", "0x10", "010", "2.5", "1e3", "-3", "99999999999999999999", "''"}) {
        const Ended refused = run(simulate + wrong);
        EXPECT_EQ(refused.code, 2) << wrong << refused.all();
        expect_words(refused.err, {"allowed: a "});
    }
    for (const char* wrong :
         {"--seed -1 --cases 1", "--seed 99999999999999999999 --cases 1", "--seed 1 --cases -1", "--seed 1e2 --cases 1"}) {
        const Ended refused = run("blind make --out b " + std::string(wrong));
        EXPECT_EQ(refused.code, 2) << wrong << refused.all();
        expect_words(refused.err, {"allowed: a whole number"});
    }
    EXPECT_FALSE(fs::exists(folder_ / "b"));
}

TEST_F(BadInput, AnOutFolderThatCannotBe) {
    write("out.txt", "a file");
    const Ended refused = run("make '" + fixtures::shipped("pnrvsa").string() + "' --out out.txt");
    EXPECT_EQ(refused.code, 2) << refused.all();
    expect_words(refused.err, {"out.txt", "is a file, not a folder"});
    EXPECT_EQ(core::read_file(folder_ / "out.txt"), "a file");
}

}  // namespace
}  // namespace fusee::app
