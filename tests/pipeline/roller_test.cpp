#include <algorithm>
#include <set>

#include "fusee/batch/batch.h"
#include "fusee/core/error.h"
#include "fusee/exchange/part_file.h"
#include "fusee/formats/format.h"
#include "fusee/pipeline/simulate.h"
#include "fusee/report/simulation.h"
#include "pipeline/fixture.h"

// The shipped roller cam as a user makes it, and the same profile broken.
namespace fusee::pipeline {
namespace {

class RollerMade : public fixtures::TempFolder {
protected:
    std::string example() const { return core::read_file(fixtures::shipped("examples/roller_follower")); }
    profile::Profile changed(const std::string& key, const std::string& value) const {
        return profile::read_profile(write("roller.toml", fixtures::with_key(example(), key, value)));
    }
};

TEST_F(RollerMade, CarriesItsLawInEveryFile) {
    const std::string formats = R"(["stl", "scad", "dxf", "3mf", "step", "ngc"])";
    const batch::MakeResult result = batch::make(changed("outputs.formats", formats), {.out = folder_ / "out"});
    for (const core::Finding& f : result.findings)  // its G-code is for another process than it is printed by
        EXPECT_EQ(core::is_broken(f), f.rule == "toolpath.process") << core::to_line(f);
    ASSERT_TRUE(result.made);
    for (const core::Finding& f : result.findings) {
        if (!f.where.starts_with("k_pe")) continue;
        for (const char* group : {"cable.", "groove.", "collision."}) EXPECT_FALSE(f.rule.starts_with(group)) << core::to_line(f);
    }
    const exchange::PartFile part = exchange::read_part_file(result.folder / "k_pe.json");
    EXPECT_EQ(part.guide.kind, "roller");
    EXPECT_EQ(part.cable_diameter_mm, 0.0);
    EXPECT_NEAR(part.guide.start_mm, 40.0, 1e-9);  // base and roller radius
    std::set<std::string> readers;
    for (const readback::ArmError& e : formats::read_back(result.folder, part)) {
        EXPECT_TRUE(e.passed()) << e.file << " " << e.reader << " " << e.worst_relative;
        readers.insert(e.reader);
    }
    for (const char* reader : {"assimp", "openmesh", "lib3mf", "dxflib", "dxflib, spline", "opencascade"})
        EXPECT_TRUE(readers.contains(reader)) << reader;
}

/// Arms that fall from 40 to 10 mm within a few rows: the part file's own check of lift against arms lets them pass.
TEST_F(RollerMade, WithASpringThatIsHardlyPreloaded) {
    const std::string steep = fixtures::with_keys(example(), {{"outputs.formats", R"(["stl"])"},
                                                              {"outputs.pair", "false"},
                                                              {"tolerances.chordal_error_mm", "0.001"},
                                                              {"k_pe.spring.preload_mm", "0.4"},
                                                              {"k_pe.spring.rate_N_per_m", "20000"},
                                                              {"k_pe.spring.wire_mm", "0"},
                                                              {"k_pe.spring.max_travel_mm", "0"},
                                                              {"k_pe.spring.max_force_N", "0"},
                                                              {"k_pe.roller.radius_mm", "4"},
                                                              {"k_pe.roller.base_radius_mm", "200"},
                                                              {"process.build_mm", "[600.0, 600.0, 200.0]"}});
    const batch::MakeResult result = batch::make(profile::read_profile(write("roller.toml", steep)), {.out = folder_ / "out"});
    EXPECT_TRUE(result.made);
    EXPECT_LT(result.file_errors.arm, 1e-3);
}

/// What the rules hold against K_PE, required or for review.
std::set<std::string> objections(const batch::MakeResult& result) {
    std::set<std::string> ids;
    for (const core::Finding& f : result.findings)
        if (core::is_broken(f)) ids.insert(f.rule);
    return ids;
}

TEST_F(RollerMade, ABaseTooSmallIsRefusedWithALargerOne) {
    const batch::MakeResult result = batch::make(changed("k_pe.roller.base_radius_mm", "0.5"), {.out = folder_ / "out"});
    EXPECT_FALSE(result.made);
    bool named = false;
    for (const core::Finding& f : result.findings) named |= f.suggestion.text().find("k_pe.roller.base_radius_mm = ") != std::string::npos;
    EXPECT_TRUE(named);
    EXPECT_FALSE(objections(result).empty());
}

TEST_F(RollerMade, ARollerWiderThanItsRimIsRefused) {
    const batch::MakeResult result = batch::make(changed("k_pe.roller.width_mm", "11.0"), {.out = folder_ / "out"});
    EXPECT_FALSE(result.made);
    EXPECT_TRUE(objections(result).contains("roller.rim_width"));
}

TEST_F(RollerMade, AGuideBesideARollerHasNoMeaning) {
    const std::string text = example() + "\n[k_pe.guide]\nkind = \"parallel\"\n";
    EXPECT_THROW((void)profile::read_profile(write("roller.toml", text)), core::InvalidInput);
}

TEST_F(RollerMade, ProfileComesBackFromItsOwnText) {
    const profile::Profile read = profile::read_profile(write("roller.toml", example()));
    const profile::Profile again = profile::read_profile(write("again.toml", profile::to_toml(read)));
    EXPECT_EQ(profile::to_toml(again), profile::to_toml(read));
    EXPECT_EQ(again.k_pe.cam.roller.radius, read.k_pe.cam.roller.radius);
}

TEST_F(RollerMade, CableWithFrictionAndStiffnessGetsItsLoop) {
    std::string text = core::read_file(fixtures::shipped("pnrvsa"));
    text = fixtures::with_key(fixtures::with_key(text, "cable.friction", "0.1"), "cable.stiffness_N", "20000");
    const auto simulation = simulate(profile::read_profile(write("loop.toml", text)));
    ASSERT_TRUE(simulation);
    ASSERT_EQ(simulation->wraps.size(), 2u);
    for (const WrapSide& side : simulation->wraps) EXPECT_GT(side.loop.dissipated, 0.0);
    EXPECT_NE(report::simulation_html(*simulation).find("Hysteresis of the cables"), std::string::npos);
    const std::string csv = report::wrap_hysteresis_csv(simulation->wraps);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 801);
    const auto without = simulate(profile::read_profile(fixtures::shipped("pnrvsa")));
    EXPECT_TRUE(without->wraps.empty());
}

}  // namespace
}  // namespace fusee::pipeline
