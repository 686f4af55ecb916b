#include "fusee/profile/follow.h"

#include "fusee/spring/coil.h"
#include "profile/fixture.h"

namespace fusee::profile {
namespace {

/// The short profile with the base springs' coils.
class Following : public ProfileTest {
protected:
    static std::string with_coils(const std::string& se, const std::string& pe) { return kShort + pe + "[k_se.hub]\nbore_mm = 6\n" + se; }
    static constexpr const char* kCompression =
        "wire_mm = 2.25\ncoil_mm = 18\nactive_coils = 6\nfree_length_mm = 46\nmax_force_N = 177\n"
        "wire_class = \"sh\"\nrod_mm = 14\n";
    /// Keys and values of the edits, as "key = value".
    std::string edits(const std::string& toml, const std::vector<Edit>& moved) const {
        std::string text;
        for (const Edit& edit : following(read(toml), moved)) text += edit.key + "=" + edit.value + " ";
        return text;
    }
    Profile made(const std::string& toml, std::vector<Edit> moved) const {
        const Profile base = read(toml);
        const std::vector<Edit> more = following(base, moved);
        moved.insert(moved.end(), more.begin(), more.end());
        return read(with_edits(toml, base, moved));
    }
    static Edit move(const std::string& key, const std::string& value) { return {key, value, "", ""}; }
    const std::string rate = "k_pe.spring.rate_N_per_m";
};

TEST_F(Following, TurnsThatAreNotStatedAreThoseOfTheRate) {
    const spring::BaseSpring s = read(std::string(kShort) + "wire_mm = 2.25\ncoil_mm = 18\n").k_pe.spring;
    EXPECT_NEAR(s.active_coils, 6.0, 0.01);
    EXPECT_NEAR(spring::rate_of_coils(s), 7460.0, 1e-6);
    EXPECT_EQ(read(std::string(kShort) + "wire_mm = 2.25\n").k_pe.spring.active_coils, 0.0);
    // Fewer turns than the key allows are a finding of spring.active_coils, and survive being written.
    const Profile stiff = read(std::string(kShort) + "wire_mm = 0.6\ncoil_mm = 18\n");
    EXPECT_LT(stiff.k_pe.spring.active_coils, 0.1);
    EXPECT_EQ(read(to_toml(stiff)).k_pe.spring.active_coils, stiff.k_pe.spring.active_coils);
}

TEST_F(Following, ARateMayBeLeftOutWhereItsCoilsAreStated) {
    const std::string toml = edited("rate_N_per_m = 7460\n", ""), coils = "wire_mm = 2.25\ncoil_mm = 18\nactive_coils = 6\n";
    EXPECT_NEAR(read(toml + coils).k_pe.spring.rate, 7462.0, 1.0);
    expect_words(refusal(toml), {"k_pe.spring.rate_N_per_m: missing"});
    expect_words(refusal(toml + "wire_mm = 2.25\ncoil_mm = 18\n"), {"k_pe.spring.rate_N_per_m: missing"});
    expect_words(refusal(toml + "wire_mm = 18\ncoil_mm = 18\nactive_coils = 6\n"), {"k_pe.spring.rate_N_per_m: missing"});
}

TEST_F(Following, AnotherRateWindsAnotherSpring) {
    const std::string toml = std::string(kShort) + kCompression;
    EXPECT_EQ(edits(toml, {move(rate, "9000")}),
              "k_pe.spring.active_coils= k_pe.spring.free_length_mm= k_pe.spring.max_force_N= k_pe.spring.rod_mm=14 ");
    const spring::BaseSpring s = made(toml, {move(rate, "9000")}).k_pe.spring;
    EXPECT_NEAR(spring::rate_of_coils(s), 9000.0, 1e-6);
    EXPECT_EQ(s.free_length, 0.0);  // pipeline::resolve derives it from the law
}

TEST_F(Following, AnotherWireKeepsTheRateAndOtherTurnsGiveAnother) {
    const std::string toml = std::string(kShort) + kCompression;
    const spring::BaseSpring thick = made(toml, {move("k_pe.spring.wire_mm", "2.5")}).k_pe.spring;
    EXPECT_EQ(thick.rate, 7460.0);
    EXPECT_NEAR(spring::rate_of_coils(thick), 7460.0, 1e-6);
    EXPECT_LT(thick.rod_diameter, spring::inside_diameter(thick, 0.0));
    const spring::BaseSpring wound = made(toml, {move("k_pe.spring.active_coils", "7")}).k_pe.spring;
    EXPECT_NEAR(wound.rate, 7462.0 * 6.0 / 7.0, 1.0);
}

/// Both move: what the caller says holds, and the rules judge it.
TEST_F(Following, WhatMovesItselfDoesNotFollow) {
    const spring::BaseSpring s =
        made(std::string(kShort) + kCompression, {move(rate, "9000"), move("k_pe.spring.active_coils", "9")}).k_pe.spring;
    EXPECT_EQ(s.rate, 9000.0);
    EXPECT_EQ(s.active_coils, 9.0);
}

TEST_F(Following, NothingFollowsWithoutCoilsAndARatingOfUnknownWireStays) {
    EXPECT_EQ(edits(std::string(kShort) + "active_coils = 6\nmax_force_N = 177\n", {move(rate, "9000")}), "");
    const std::string unknown = std::string(kShort) + "wire_mm = 2.25\ncoil_mm = 18\nactive_coils = 6\nmax_force_N = 177\n";
    EXPECT_EQ(edits(unknown, {move(rate, "9000")}), "k_pe.spring.active_coils= ");
    EXPECT_EQ(edits(std::string(kShort) + kCompression, {move("process.kind", "\"sla\"")}), "");
}

TEST_F(Following, CableAndShaftTakeTheirPartsAlong) {
    const std::string toml = edited("diameter_mm = 0.8\n", "diameter_mm = 0.8\nbreaking_load_N = 800\n") +
                             "[k_se.hub]\nbore_mm = 6\nkey_width_mm = 2\nkey_depth_mm = 1\n[k_se.features]\nanchor_edge_mm = 0.4\n";
    EXPECT_EQ(edits(toml, {move("cable.diameter_mm", "0.4")}), "cable.breaking_load_N=200 k_se.features.anchor_edge_mm=0.2 ");
    EXPECT_EQ(edits(toml, {move("k_se.hub.bore_mm", "10")}), "k_se.hub.key_width_mm=3 k_se.hub.key_depth_mm=1.4 ");
}

TEST_F(Following, AnchorsFollowAContourThatMovesUnlessTheirMarginDoes) {
    Profile p = read(std::string(kShort) + "[k_se.path]\nmargin_deg = 60\n[k_pe.path]\nmargin_deg = 75\n");
    let_anchors_follow(p, {move("process.kind", "\"sla\"")});
    EXPECT_TRUE(p.places.contains("k_se.path.margin_deg"));
    let_anchors_follow(p, {move("law.c_Nm", "0.27"), move("k_pe.path.margin_deg", "70")});
    EXPECT_FALSE(p.places.contains("k_se.path.margin_deg"));
    EXPECT_TRUE(p.places.contains("k_pe.path.margin_deg"));
}

TEST_F(Following, AnEditWithoutAValueLeavesItsKeyOut) {
    const auto without = [&](const std::string& toml, const char* key) { return with_edits(toml, read(toml), {{key, "", "", ""}}); };
    const std::string lines = std::string(kShort) + "wire_mm = 2.25  # wound\ncoil_mm = 18\n";
    EXPECT_EQ(without(lines, "k_pe.spring.wire_mm"), std::string(kShort) + "coil_mm = 18\n");
    EXPECT_EQ(without(lines, "k_pe.spring.coil_mm"), std::string(kShort) + "wire_mm = 2.25  # wound\n");
    EXPECT_EQ(without(lines, "k_pe.spring.rod_mm"), lines);
    const std::string table = "rate_N_per_m = 7460\npreload_mm = 14.6\n";
    const auto inlined = [&](const std::string& values) {
        return edited("[k_pe.spring]\n" + table, "[k_pe]\nspring = {" + values + "}\n");
    };
    const std::string all = inlined("wire_mm = 2.25, rate_N_per_m = 7460, preload_mm = 14.6, coil_mm = 18");
    EXPECT_EQ(without(all, "k_pe.spring.wire_mm"), inlined("rate_N_per_m = 7460, preload_mm = 14.6, coil_mm = 18"));
    EXPECT_EQ(without(all, "k_pe.spring.coil_mm"), inlined("wire_mm = 2.25, rate_N_per_m = 7460, preload_mm = 14.6"));
    const Profile p = read(lines);
    expect_words(with_edits(lines, p, {{"k_pe.spring.coil_mm", "", "18", "follows the rate"}}), {"# coil_mm was 18: follows the rate\n"});
}

TEST_F(Following, HalfPlatesHaveTheirDowelsWhereTheyAreMilled) {
    const auto pin_of = [&](const std::string& process, const std::string& more) {
        const Profile p = read(edited("kind = \"fdm\"", "kind = \"" + process + "\"") + more);
        EXPECT_EQ(p.k_pe.solid.dowel_diameter, 0.0) << "wrapped";
        return p.k_se.solid.dowel_diameter;
    };
    const std::string ngc = "[outputs]\nformats = [\"step\", \"ngc\"]\n";
    EXPECT_EQ(pin_of("mill", ngc), 2e-3);
    EXPECT_EQ(pin_of("mill4", ngc + "[machining]\ndowel_diameter_mm = 3\n"), 3e-3);
    EXPECT_EQ(pin_of("mill", ngc + "[machining]\nk_se = \"wrap\"\n"), 0.0);
    EXPECT_EQ(pin_of("mill", ""), 0.0) << "who has no G-code mills one piece";
    EXPECT_EQ(pin_of("fdm", ngc), 0.0);
}

}  // namespace
}  // namespace fusee::profile
