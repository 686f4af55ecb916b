#include <set>

#include "fixture.h"
#include "fusee/spring/coil.h"
#include "refused.h"

namespace fusee::study {
namespace {

class Plans : public StudyFolder {};

constexpr const char* kTwoKeys = "[vary]\ncable.diameter_mm = [0.6, 0.8]\n\"k_se.hub.bore_mm\" = {from = 5.0, to = 6.0, steps = 3}\n";

TEST_F(Plans, AGridHasEveryCombinationUnderReadableNames) {
    const Plan plan(study(kTwoKeys));
    std::vector<std::string> names;
    for (std::size_t i = 0; i < plan.size(); ++i) names.push_back(plan.at(i).name);
    EXPECT_EQ(names, (std::vector<std::string>{"pnrvsa-diameter_mm-0.6-bore_mm-5", "pnrvsa-diameter_mm-0.6-bore_mm-5.5",
                                               "pnrvsa-diameter_mm-0.6-bore_mm-6", "pnrvsa-diameter_mm-0.8-bore_mm-5",
                                               "pnrvsa-diameter_mm-0.8-bore_mm-5.5", "pnrvsa-diameter_mm-0.8-bore_mm-6"}));
}

TEST_F(Plans, AProfileHasTheValuesOfItsDesign) {
    const Plan plan(study(kTwoKeys));
    const profile::Profile profile = plan.profile(plan.at(1));
    EXPECT_EQ(profile.name, "pnrvsa-diameter_mm-0.6-bore_mm-5.5");
    EXPECT_EQ(profile.cable.diameter, 0.6e-3);
    EXPECT_EQ(profile.k_se.solid.hub.bore_diameter, 5.5e-3);
}

/// A study of rates kept the turns of its base: 20 of the first 60 designs of the shipped study were refused by spring.rate.
TEST_F(Plans, ASpringOfAnotherRateHasOtherTurns) {
    const Plan plan(study("[vary]\nk_pe.spring.rate_N_per_m = [6000.0, 9000.0]\nk_se.spring.wire_mm = [1.0, 1.2]\n"));
    for (std::size_t i = 0; i < plan.size(); ++i) {
        const profile::Profile p = plan.profile(plan.at(i));
        EXPECT_NEAR(spring::rate_of_coils(p.k_pe.spring) / p.k_pe.spring.rate, 1.0, 1e-9) << i;
        EXPECT_NEAR(spring::rate_of_coils(p.k_se.spring) / 0.0183, 1.0, 1e-9) << i;
        EXPECT_FALSE(p.places.contains("k_se.path.margin_deg"));
    }
}

TEST_F(Plans, AConstraintOnWhatFollowsIsJudgedOnTheDesign) {
    const Plan plan(
        study("[vary]\nk_pe.spring.rate_N_per_m = [6000.0, 9000.0]\n"
              "[constraints]\nfew = \"k_pe.spring.active_coils < 7\"\n"));  // 7.5 and 5 turns; the base has 6
    EXPECT_EQ(plan.at(0).excluded_by, "few");
    EXPECT_EQ(plan.at(1).excluded_by, "");
}

TEST_F(Plans, AConstraintLeavesDesignsOut) {
    const Plan plan(
        study(std::string(kTwoKeys) + "[constraints]\nthin = \"cable.diameter_mm*7 > k_se.hub.bore_mm - 1e-9*rig.peak_torque_Nm\"\n"));
    std::vector<std::string> excluded;
    for (std::size_t i = 0; i < plan.size(); ++i) excluded.push_back(plan.at(i).excluded_by);
    EXPECT_EQ(excluded, (std::vector<std::string>{"thin", "thin", "thin", "", "", "thin"}));  // 4.2 and 5.6 against 5, 5.5, 6
}

TEST_F(Plans, ALogarithmicRangeHasEqualRatios) {
    const Plan plan(study("[vary]\ncable.diameter_mm = {from = 0.25, to = 1.0, steps = 3, scale = \"logarithmic\"}\n"));
    EXPECT_EQ(plan.at(1).values, std::vector<std::string>{"0.5"});
}

TEST_F(Plans, SampledNamesAreNumbersOfOneLength) {
    const Plan plan(study("method = \"sobol\"\ncount = 11\n[vary]\ncable.diameter_mm = {from = 0.5, to = 1.0}\n"));
    EXPECT_EQ(plan.at(0).name, "pnrvsa-00");
    EXPECT_EQ(plan.at(10).name, "pnrvsa-10");
    EXPECT_EQ(plan.at(0).values, std::vector<std::string>{"0.75"});
}

TEST_F(Plans, ATableHasOneDesignInEachRow) {
    write("t.csv", "name,cable.diameter_mm,process.kind\nthin,0.6,fdm\nthick,1.0,sla\n");
    const Plan plan(study("method = \"csv\"\ntable = \"t.csv\"\n"));
    ASSERT_EQ(plan.size(), 2U);
    EXPECT_EQ(plan.at(1).name, "thick");
    EXPECT_EQ(plan.profile(plan.at(1)).process.kind, checks::ProcessKind::kSla);
}

TEST_F(Plans, AListOfProfilesKeepsItsOrder) {
    const Plan plan(study_of({FUSEE_SOURCE_DIR "/profiles/pnrvsa.toml", FUSEE_SOURCE_DIR "/profiles/free_curve.toml"}, "both"));
    EXPECT_EQ(plan.at(1).name, "free_curve");
    EXPECT_EQ(plan.profile(plan.at(0)).name, "pnrvsa");
}

TEST_F(Plans, LongNamesEndWithANumberAndFitAProfile) {
    const std::string base = core::read_file(FUSEE_SOURCE_DIR "/profiles/pnrvsa.toml");
    std::string text = base;
    const std::string name = "name = \"pnrvsa\"";
    text.replace(text.find(name), name.size(), "name = \"" + std::string(60, 'n') + "\"");
    write("long.toml", text);
    const Plan plan(read_study(write("s.toml", "[study]\nbase = \"long.toml\"\n" + std::string(kTwoKeys))));
    EXPECT_EQ(plan.at(0).name, std::string(60, 'n') + "-0");
    EXPECT_EQ(plan.profile(plan.at(5)).name, std::string(60, 'n') + "-5");
}

TEST_F(Plans, TextsThatLookAlikeInANameGetNumbers) {
    const std::string base = FUSEE_SOURCE_DIR "/profiles/from_dead_band.toml";
    const Plan plan(
        read_study(write("s.toml", "[study]\nbase = \"" + base + "\"\n[vary]\nlaw.dead_band_deg = [\"40 + tau\", \"40 * tau\"]\n")));
    EXPECT_EQ(plan.at(0).name, "from_dead_band-0");
    EXPECT_EQ(plan.at(1).name, "from_dead_band-1");
}

TEST_F(Plans, NamesOfAListAreThoseOfItsFiles) {
    const auto name = [](const char* file) { return Plan(study_of({file}, "s")).at(0).name; };
    EXPECT_EQ(name("a/my cam.toml"), "my_cam");
    EXPECT_EQ(name("a/_.toml"), "design_");
    EXPECT_EQ(field_refused([] { return study_of({"a/cam.toml", "b/cam.toml"}, "s"); }), "batch");
    EXPECT_EQ(field_refused([] { return study_of({"a/cam.toml"}, "a/b"); }), "--name");
}

TEST_F(Plans, ADigestIsOfTheKeysToo) {
    const auto digest = [&](const std::string& key) {
        const Plan plan(study("method = \"random\"\ncount = 1\n[vary]\n" + key + " = [6.0]\n"));
        return plan.digest(plan.at(0));
    };
    EXPECT_EQ(digest("k_se.hub.bore_mm"), digest("k_se.hub.bore_mm"));
    EXPECT_NE(digest("k_se.hub.bore_mm"), digest("k_pe.hub.bore_mm"));
}

TEST_F(Plans, ADigestIsOfTheFilesThatAValueNames) {
    const std::string shipped = FUSEE_SOURCE_DIR "/profiles/measured_table", table = core::read_file(shipped + ".csv");
    const auto digest = [&](const std::string& law) {
        const std::string file = write("law.csv", law).string();
        const Plan plan(read_study(write("s.toml", "[study]\nbase = \"" + shipped + ".toml\"\n[vary]\nlaw.file = [\"" + file + "\"]\n")));
        return plan.digest(plan.at(0));
    };
    EXPECT_EQ(digest(table), digest(table));
    EXPECT_NE(digest(table), digest("# measured again\n" + table));
}

TEST_F(Plans, AWrongValueIsOneOfTheStudy) {
    const Plan plan(study("[vary]\ncable.diameter_mm = [0.8, -1.0]\n"));
    EXPECT_TRUE(field_refused([&] { return plan.profile(plan.at(1)); }).ends_with("s.toml: vary.cable.diameter_mm"));
}

TEST_F(Plans, WrongKeysAndFormulasAreNamed) {
    const auto refused = [&](const std::string& tail) {
        std::string field = field_refused([&] { return Plan(study(tail)).size(); });
        return field.substr(field.rfind(": ") + 2);
    };
    EXPECT_EQ(refused("[vary]\ncable.thickness = [1.0]\n"), "vary");
    EXPECT_EQ(refused("[vary]\nk_pe.roller.radius_mm = [1.0]\n"), "vary.k_pe.roller.radius_mm");
    EXPECT_EQ(refused(std::string(kTwoKeys) + "[constraints]\nc = \"cable.diameter_mm <\"\n"), "constraints.c");
    EXPECT_EQ(refused(std::string(kTwoKeys) + "[constraints]\nc = \"process.kind > 1\"\n"), "constraints.c");
    EXPECT_EQ(refused(std::string(kTwoKeys) + "[constraints]\nc = \"no.key > 1\"\n"), "constraints.c");
}

}  // namespace
}  // namespace fusee::study
