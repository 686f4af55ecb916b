#include "fusee/profile/edit.h"

#include "profile/fixture.h"

namespace fusee::profile {
namespace {

class ProfileEdit : public ProfileTest {
protected:
    /// The text with the edits made, which must be read again.
    std::string made(const std::string& toml, const std::vector<Edit>& edits) const {
        const std::string text = with_edits(toml, read(toml), edits);
        EXPECT_EQ(refusal(text), "");
        return text;
    }
    Edit rate(double value) const { return number_edit(read(kShort), "k_se.spring.rate_Nm_per_rad", value, "measured"); }
};

TEST_F(ProfileEdit, ReplacesTheValueAndNothingElse) {
    const std::string toml = edited("rate_Nm_per_rad = 0.0183\n", "rate_Nm_per_rad =  0.0183   # as bought\n");
    std::string expected = toml;
    expected.replace(expected.find("rate_Nm_per_rad =  0.0183"), 25, "# rate_Nm_per_rad was 0.0183: measured\nrate_Nm_per_rad =  0.0201");
    EXPECT_EQ(made(toml, {rate(0.0201)}), expected);
}

/// The comment behind a value belongs to that value; one on a separate line stays.
TEST_F(ProfileEdit, ReplacesTheCommentThatSpokeOfTheOldValue) {
    const std::string toml = edited("rate_Nm_per_rad = 0.0183\n", "# torsion spring\nrate_Nm_per_rad = 0.0183   # as bought\n");
    Edit measured = rate(0.0201);
    measured.origin = "measured, case bench_3";
    expect_words(made(toml, {measured}), {"# torsion spring\n# rate_Nm_per_rad was 0.0183: measured\n"
                                          "rate_Nm_per_rad = 0.0201   # measured, case bench_3\n"});
    EXPECT_EQ(made(toml, {measured}).find("as bought"), std::string::npos);
    // No comment, no new one; what follows in a table of one line speaks of all its keys.
    EXPECT_EQ(made(kShort, {measured}).find("bench_3"), std::string::npos);
    const std::string inlined = edited("[k_se.spring]\nrate_Nm_per_rad = 0.0183\npreload_rad = 3.6\n",
                                       "[k_se]\nspring = {preload_rad = 3.6, rate_Nm_per_rad = 0.0183} # both as bought\n");
    expect_words(made(inlined, {measured}), {"rate_Nm_per_rad = 0.0201} # both as bought\n"});
}

TEST_F(ProfileEdit, LeavesOutWhatLosesItsMeaning) {
    const std::string toml = std::string(kShort) + "\n[k_pe.path]\nkind = \"helix\"\npitch_mm = 5.0  # steep\n";
    const Profile p = read(toml);
    const std::string text = made(toml, {text_edit(p, "k_pe.path.kind", "planar", "a stack")});
    expect_words(text, {"kind = \"planar\"\n# only with k_pe.path.kind = \"helix\": pitch_mm = 5.0  # steep\n"});
    const std::string one_line = std::string(kShort) + "\n[k_pe]\npath = {kind = \"helix\", pitch_mm = 5.0}\n";
    EXPECT_THROW((void)with_edits(one_line, read(one_line), {text_edit(read(one_line), "k_pe.path.kind", "planar", "a stack")}),
                 core::InvalidInput);
}

TEST_F(ProfileEdit, ReplacesArrays) {
    const std::string toml = edited("kind = \"fdm\"\n", "kind = \"fdm\"\nbuild_mm = [200, 200,\n  200]  # the old machine\n");
    expect_words(made(toml, {{"process.build_mm", "[300, 300, 200]", "[200, 200, 200]", "larger", "changed by fix"}}),
                 {"build_mm = [300, 300, 200]  # changed by fix\n"});
}

TEST_F(ProfileEdit, KnowsKeysAndTables) {
    EXPECT_NO_THROW(require_key("--keep", "k_pe.hub.bore_mm"));
    EXPECT_NO_THROW(require_key("--keep", "k_pe.hub"));
    try {
        require_key("--keep", "k_pe.hub.bore");
        FAIL() << "accepted";
    } catch (const core::InvalidInput& e) {
        expect_words(e.what(), {"--keep", "k_pe.hub.bore", "nearest known one: k_pe.hub.bore_mm"});
    }
}

TEST_F(ProfileEdit, AddsWhatIsLeftOutBelowItsHeadingOrWithItsTable) {
    const Profile p = read(kShort);
    const std::string below = made(kShort, {number_edit(p, "rig.joint_friction_Nm", 0.0125, "bearing")});
    expect_words(below, {"[rig]\n# joint_friction_Nm was 0: bearing\njoint_friction_Nm = 0.0125\ncapstan_radius_mm = 30"});
    // [k_se.spring] is in the file without [k_se].
    const std::string text = made(kShort, {number_edit(p, "k_se.radius_allowance_mm", 3e-4, "cable")});
    EXPECT_TRUE(text.ends_with("\n\n[k_se]\n# radius_allowance_mm was 0: cable\nradius_allowance_mm = 0.3\n")) << text;
    EXPECT_EQ(read(text).k_se.allowance.radius, 3e-4);
    EXPECT_EQ(read(text).k_pe.allowance.radius, 0.0);
}

TEST_F(ProfileEdit, KeepsLineEndsAndByteOrderMark) {
    std::string toml = std::string("\xEF\xBB\xBF") + kShort;
    for (std::size_t at = 0; (at = toml.find('\n', at)) != std::string::npos; at += 2) toml.replace(at, 1, "\r\n");
    const Profile p = read(toml);
    const std::string text =
        with_edits(toml, p, {text_edit(p, "name", "redesign", "new cams"), number_edit(p, "rig.gear_friction", 0.364, "+30 %")}, "# head");
    EXPECT_TRUE(text.starts_with("\xEF\xBB\xBF# head\r\n# name was \"short\": new cams\r\nname = \"redesign\"\r\n")) << text;
    expect_words(text, {"\r\n# gear_friction was 0.28: +30 %\r\ngear_friction = 0.364\r\n"});
    EXPECT_EQ(read(text).name, "redesign");
}

TEST_F(ProfileEdit, InlineTablesAreEditedButNotAddedTo) {
    const std::string toml = edited("[k_se.spring]\nrate_Nm_per_rad = 0.0183\npreload_rad = 3.6\n",
                                    "[k_se]\nspring = {preload_rad = 3.6, rate_Nm_per_rad = 0.0183} # \xC3\xA4\n");
    expect_words(made(toml, {rate(0.02)}), {"spring = {preload_rad = 3.6, rate_Nm_per_rad = 0.02} # \xC3\xA4\n"});
    const Profile p = read(toml);
    try {
        (void)with_edits(toml, p, {number_edit(p, "k_se.spring.max_torque_Nm", 1.0, "x")});
        FAIL() << "accepted";
    } catch (const core::InvalidInput& e) {
        expect_words(e.what(), {"p.toml", "k_se.spring.max_torque_Nm", "a heading [k_se.spring]"});
    }
}

TEST_F(ProfileEdit, FilesAreNamedFromTheNewFolder) {
    core::write_file(folder_ / "gear.csv", "load_Nm,friction_Nm\n0.2,0.06\n2,0.6\n");
    const std::string toml = edited("gear_friction = 0.28", "gear_friction_table = 'gear.csv'");
    const Profile p = read(toml);
    EXPECT_TRUE(file_edits(p, folder_).empty());
    const std::string text = with_edits(toml, p, file_edits(p, folder_ / "deeper"));
    expect_words(text, {"gear_friction_table = \"../gear.csv\"\n"});
    std::filesystem::create_directories(folder_ / "deeper");
    EXPECT_EQ(parse_profile(text, folder_ / "deeper" / "q.toml").rig.gear_friction_table.y, p.rig.gear_friction_table.y);
}

// Two profiles of one folder are made into one folder: their names differ, also after a command that was run twice.
TEST(DerivedName, IsAnotherName) {
    EXPECT_EQ(derived_name("elbow", "-fixed"), "elbow-fixed");
    EXPECT_EQ(derived_name("elbow-fixed", "-fixed"), "elbow-fixed-2");
    EXPECT_EQ(derived_name("elbow-fixed-9", "-fixed"), "elbow-fixed-10");
    EXPECT_EQ(derived_name("elbow-springs", "-fixed"), "elbow-springs-fixed");
    EXPECT_EQ(derived_name("elbow-fixed-springs", "-fixed"), "elbow-fixed-springs-fixed");
    EXPECT_EQ(derived_name("elbow-fixed-99999999999", "-fixed"), "elbow-fixed-99999999999-fixed");
    EXPECT_EQ(derived_name("-fixed", "-fixed"), "-fixed-fixed");
    const std::string longest(kLongestName, 'x');
    EXPECT_EQ(derived_name(longest, "-fixed"), std::string(kLongestName - 6, 'x') + "-fixed");
    EXPECT_EQ(derived_name(derived_name(longest, "-fixed"), "-fixed"), std::string(kLongestName - 8, 'x') + "-fixed-2");
}

}  // namespace
}  // namespace fusee::profile
