#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "checks/known_bad.h"
#include "fusee/core/change.h"

// Law: a part with the suggested change passes the rule.
namespace fusee::checks {
namespace {

/// The number behind `key = ` in a suggestion.
double suggested(const core::Finding& f, const std::string& key) {
    const std::size_t at = f.suggestion.text().find(key + " = ");
    EXPECT_NE(at, std::string::npos) << key << " in " << f.suggestion.text();
    return at == std::string::npos ? std::nan("") : std::strtod(f.suggestion.text().c_str() + at + key.size() + 3, nullptr);
}

/// The same law on another base spring: the energy of every position stays.
void respring(Fixture& b, double rate, double preload) {
    for (cam::Contact& c : b.part.cam.working) {
        const double energy = 0.5 * b.spring.rate * (c.arm.state * c.arm.state - b.spring.preload * b.spring.preload);
        c.arm.state = std::sqrt(preload * preload + 2.0 * energy / rate);
    }
    b.spring.rate = rate;
    b.spring.preload = preload;
}

void expect_pass(const char* rule, const Fixture& b) {
    const core::Finding f = worst(rule, b);
    EXPECT_EQ(f.severity, core::Severity::kPass) << core::to_line(f);
}

TEST(Suggestion, ThinnerCableBendsEnough) {
    Fixture b = spool();
    for (cam::Contact& c : b.part.cam.working) c.path.rho = 2.2 * kMm;
    b.cable.min_bend_ratio = 8.0;
    b.cable.diameter = kMm * suggested(worst("cable.bend_ratio", b), "cable.diameter_mm");
    expect_pass("cable.bend_ratio", b);
    EXPECT_GT(b.cable.diameter, 0.48 * kMm) << "the nearest: 2 rho/9 = 0.489 mm";
}

TEST(Suggestion, TorsionPreloadOrRateKeepsTheWinding) {
    Fixture preload = spool();
    preload.spring.max_state = 9.5;
    Fixture rate = preload;
    const core::Finding f = worst("spring.torsion_angle", preload);
    respring(preload, preload.spring.rate, suggested(f, "k_se.spring.preload_rad"));
    respring(rate, suggested(f, "k_se.spring.rate_Nm_per_rad"), rate.spring.preload);
    expect_pass("spring.torsion_angle", preload);
    expect_pass("spring.torsion_angle", rate);
}

TEST(Suggestion, CompressionPreloadOrRateKeepsTheTravel) {
    Fixture preload = pusher();
    preload.spring.max_state = 18.0 * kMm;
    Fixture rate = preload;
    const core::Finding f = worst("spring.travel", preload);
    respring(preload, preload.spring.rate, kMm * suggested(f, "k_pe.spring.preload_mm"));
    respring(rate, suggested(f, "k_pe.spring.rate_N_per_m"), rate.spring.preload);
    expect_pass("spring.travel", preload);
    expect_pass("spring.travel", rate);
}

TEST(Suggestion, SofterSpringKeepsLoadAndStress) {
    Fixture load = pusher(), stress = pusher();
    load.spring.max_load = 140.0;
    stress.spring.tensile_strength = 1900e6;
    respring(load, suggested(worst("spring.load", load), "k_pe.spring.rate_N_per_m"), load.spring.preload);
    respring(stress, stress.spring.rate, kMm * suggested(worst("spring.stress", stress), "k_pe.spring.preload_mm"));
    expect_pass("spring.load", load);
    expect_pass("spring.stress", stress);
}

/// The change with all its keys, taken over.
void rewind(Fixture& b, const core::Finding& f, const std::string& keys) {
    b.spring.wire_diameter = kMm * suggested(f, keys + "wire_mm");
    b.spring.coil_diameter = kMm * suggested(f, keys + "coil_mm");
    b.spring.active_coils = suggested(f, keys + "active_coils");
}

bool names(const core::Finding& f, const std::string& text) { return f.suggestion.text().find(text) != std::string::npos; }

// Rates that are far off: turns and wire that nobody can wind are not suggested.
TEST(Suggestion, CoilsForARateCanBeWound) {
    for (const double factor : {1e-4, 1e-3, 0.5, 2.0, 30.0, 1e3}) {
        SCOPED_TRACE(factor);
        for (Fixture b : {spool(), pusher()}) {
            const std::string keys = b.spring.kind == spring::BaseKind::kTorsion ? "k_se.spring." : "k_pe.spring.";
            if (b.spring.active_coils <= 0.0) b.spring.active_coils = spring::turns_for_rate(b.spring);
            b.spring.rate *= factor;
            const core::Finding f = worst("spring.rate", b);
            ASSERT_EQ(f.severity, core::Severity::kError) << core::to_line(f);
            if (names(f, "can be wound"))
                rewind(b, f, keys);
            else if (names(f, "active_coils"))
                b.spring.active_coils = suggested(f, keys + "active_coils");
            else if (names(f, "wire_mm"))
                b.spring.wire_diameter = kMm * suggested(f, keys + "wire_mm");
            else {
                EXPECT_TRUE(names(f, "no wound spring")) << f.suggestion.text();
                continue;
            }
            EXPECT_EQ(worst("spring.rate", b).severity, core::Severity::kPass) << f.suggestion.text();
            EXPECT_NE(worst("spring.index", b).severity, core::Severity::kError) << f.suggestion.text();
            EXPECT_NE(worst("spring.active_coils", b).severity, core::Severity::kError) << f.suggestion.text();
        }
    }
    Fixture far = pusher();
    far.spring.rate = 1e9;
    EXPECT_TRUE(names(worst("spring.rate", far), "no wound spring")) << worst("spring.rate", far).suggestion.text();
    EXPECT_FALSE(names(worst("spring.rate", far), "active_coils ="));
}

TEST(Suggestion, NoWireIsStrongerThanTheStandards) {
    Fixture b = spool();
    b.spring.tensile_strength = 100e6;
    b.spring.wire_class = spring::WireClass::kUnknown;
    Fixture near = b;
    near.spring.tensile_strength = 1100e6;
    EXPECT_TRUE(names(worst("spring.stress", near), "tensile_strength_MPa = "));
    b.spring.wire_diameter *= 0.25;
    EXPECT_TRUE(names(worst("spring.stress", b), "no stronger wire")) << worst("spring.stress", b).suggestion.text();
    EXPECT_FALSE(names(worst("spring.stress", b), "tensile_strength_MPa ="));
}

TEST(Suggestion, ASlenderSpringIsShortenedOnlyWhereItsTravelFits) {
    Fixture b = pusher();
    b.spring.free_length = 200.0 * kMm;
    EXPECT_TRUE(names(worst("spring.buckling", b), "guide tube"));
    b.spring.active_coils = 200.0;
    EXPECT_TRUE(names(worst("spring.buckling", b), "no shorter spring")) << worst("spring.buckling", b).suggestion.text();
    EXPECT_FALSE(names(worst("spring.buckling", b), "free_length_mm ="));
}

/// r = sqrt((k_t phi0)^2 + 2 k_t U)/U' and U'/sqrt((k y0)^2 + 2 k U): the suggested spring scales every arm alike.
TEST(Suggestion, ScaledSpringScalesEveryArm) {
    Fixture b = spool();
    b.part.options.hub.bore_diameter = 18.0 * kMm;
    const core::Finding f = worst("cam.arm_range", b);
    const double rate = suggested(f, "k_se.spring.rate_Nm_per_rad");
    const double factor = f.allowed / f.measured;
    Fixture scaled = spool();
    respring(scaled, rate, b.spring.preload / factor);
    for (std::size_t i = 0; i < b.part.cam.working.size(); i += 20) {
        const double before = b.spring.rate * b.part.cam.working[i].arm.state, after = rate * scaled.part.cam.working[i].arm.state;
        EXPECT_NEAR(after / before, factor, 2e-4 * factor) << "the rate is printed with four digits";
    }
}

TEST(Suggestion, GrooveAndHubSizesPass) {
    Fixture b = helix(10.0 * kMm, 3.0 * kMm);
    expect_pass("groove.pitch", helix(10.0 * kMm, kMm * (suggested(worst("groove.pitch", b), "k_pe.path.pitch_mm") + 0.2)));
    Fixture thin = spool();
    thin.part.options.hub.bore_diameter = 15.0 * kMm;
    thin.part.options.hub.bore_diameter = kMm * suggested(worst("structure.wall_to_bore", thin), "k_se.hub.bore_mm");
    expect_pass("structure.wall_to_bore", thin);
    Fixture slot = spool();
    slot.part.options.features.leg_slot_radius = 6.6 * kMm;
    slot.part.options.features.leg_slot_radius = kMm * suggested(worst("structure.leg_slot", slot), "k_se.features.leg_slot_radius_mm");
    expect_pass("structure.leg_slot", slot);
    Fixture throat = spool();
    throat.part.options.groove.throat = core::rad_from_deg(60.0);
    cut_groove(throat);
    throat.part.options.groove.throat = core::rad_from_deg(suggested(worst("collision.printed_throat", throat), "groove.throat_deg"));
    cut_groove(throat);
    expect_pass("collision.printed_throat", throat);
    expect_pass("groove.throat", throat);
}

TEST(Suggestion, ThickerCablePressesLess) {
    Fixture b = spool();
    b.cable.max_pressure = 5e6;
    b.cable.diameter = kMm * suggested(worst("cable.pressure", b), "cable.diameter_mm");
    expect_pass("cable.pressure", b);
}

/// Every free cable becomes longer, and the leaning ones lean less.
void set_guide_distance(Fixture& b, double distance_mm) {
    const double farther = distance_mm * kMm - b.part.cam.options.guide.distance;
    for (cam::Contact& c : b.part.cam.working) {
        c.fleet = std::atan(std::tan(c.fleet) * c.span / (c.span + farther));
        c.span += farther;
    }
    b.part.cam.options.guide.distance = distance_mm * kMm;
}

/// Keys of a profile that a part made by hand can follow: the value in the key's unit.
const std::map<std::string, std::function<void(Fixture&, double)>>& keys() {
    static const std::map<std::string, std::function<void(Fixture&, double)>> all = {
        {"groove.depth_ratio", [](Fixture& b, double v) { b.part.options.groove.depth_ratio = v, cut_groove(b); }},
        {"groove.radius_ratio", [](Fixture& b, double v) { b.part.options.groove.radius_ratio = v, cut_groove(b); }},
        {"groove.throat_deg", [](Fixture& b, double v) { b.part.options.groove.throat = core::rad_from_deg(v), cut_groove(b); }},
        {"groove.plate_mm", [](Fixture& b, double v) { b.part.options.groove.plate = v * kMm; }},
        {"groove.rib_mm", [](Fixture& b, double v) { b.part.options.groove.rib = v * kMm, cut_groove(b); }},
        {"process.layer_mm", [](Fixture& b, double v) { b.process.layer = v * kMm; }},
        {"process.cutter_radius_mm", [](Fixture& b, double v) { b.process.cutter_radius = v * kMm; }},
        {"process.tolerance_mm", [](Fixture& b, double v) { b.process.tolerance = v * kMm; }},
        {"cable.breaking_load_N", [](Fixture& b, double v) { b.cable.breaking_load = v; }},
        {"flange_height_mm", [](Fixture& b, double v) { b.part.options.flange_height = v * kMm; }},
        {"guide.distance_mm", set_guide_distance},
        {"features.leg_slot_angle_deg", [](Fixture& b, double v) { b.part.options.features.leg_slot_angle = core::rad_from_deg(v); }},
        {"hub.bore_mm", [](Fixture& b, double v) { b.part.options.hub.bore_diameter = v * kMm; }},
        {"hub.clearance_mm", [](Fixture& b, double v) { b.part.options.hub.bore_clearance = v * kMm; }},
        {"hub.boss_mm", [](Fixture& b, double v) { b.part.options.hub.boss_diameter = v * kMm; }},
        {"hub.boss_height_mm", [](Fixture& b, double v) { b.part.options.hub.boss_height = v * kMm; }},
        {"hub.flat_depth_mm", [](Fixture& b, double v) { b.part.options.hub.flat_depth = v * kMm; }},
        {"hub.screw_mm", [](Fixture& b, double v) { b.part.options.hub.screw_diameter = v * kMm; }},
        {"hub.key_width_mm", [](Fixture& b, double v) { b.part.options.hub.key_width = v * kMm; }},
        {"hub.key_depth_mm", [](Fixture& b, double v) { b.part.options.hub.key_depth = v * kMm; }},
        {"hub.web_mm", [](Fixture& b, double v) { b.part.options.hub.web = v * kMm; }},
        {"features.anchor_hole_mm", [](Fixture& b, double v) { b.part.options.features.anchor_hole_diameter = v * kMm; }},
        {"features.mark_width_mm", [](Fixture& b, double v) { b.part.options.features.mark_width = v * kMm; }},
        {"features.leg_slot_width_mm", [](Fixture& b, double v) { b.part.options.features.leg_slot_width = v * kMm; }},
        {"features.leg_slot_depth_mm", [](Fixture& b, double v) { b.part.options.features.leg_slot_depth = v * kMm; }},
        {"features.leg_slot_radius_mm", [](Fixture& b, double v) { b.part.options.features.leg_slot_radius = v * kMm; }},
        {"spring.coil_mm", [](Fixture& b, double v) { b.spring.coil_diameter = v * kMm; }},
        {"spring.rod_mm", [](Fixture& b, double v) { b.spring.rod_diameter = v * kMm; }},
        {"spring.active_coils", [](Fixture& b, double v) { b.spring.active_coils = v; }},
        {"spring.free_length_mm", [](Fixture& b, double v) { b.spring.free_length = v * kMm; }},
        {"spring.wire_mm", [](Fixture& b, double v) { b.spring.wire_diameter = v * kMm; }},
        {"spring.rate_Nm_per_rad", [](Fixture& b, double v) { respring(b, v, b.spring.preload); }},
        {"spring.motion_Hz", [](Fixture& b, double v) { b.spring.motion = v; }},
        {"features.anchor_edge_mm", [](Fixture& b, double v) { b.part.options.features.anchor_edge_radius = v * kMm; }},
        {"material.modulus_MPa", [](Fixture& b, double v) { b.process.material.modulus = v * 1e6; }},
        {"spring.tensile_strength_MPa", [](Fixture& b, double v) { b.spring.tensile_strength = v * 1e6; }},
    };
    return all;
}

class Followed : public testing::TestWithParam<Case> {};

/// Each alternative that the rule suggests, as far as it is of such keys, takes the objection away.
TEST_P(Followed, TakesTheObjectionAway) {
    const core::Finding f = worst(GetParam().rule, bad(GetParam()));
    for (const core::Changes& changes : f.suggestion.changes()) {
        Fixture b = bad(GetParam());
        std::string followed;
        for (const core::Change& change : changes) {
            const bool of_part = change.key.starts_with("k_se.") || change.key.starts_with("k_pe.");
            const auto key = keys().find(of_part ? change.key.substr(5) : change.key);
            if (key == keys().end()) {
                followed.clear();  // half of what belongs together shows nothing
                break;
            }
            key->second(b, std::stod(change.value));
            followed += change.key + " = " + change.value + '\n';
        }
        if (followed.empty()) continue;
        for (const core::Finding& after : run_rule(GetParam().rule, b))
            EXPECT_LT(after.severity, f.severity) << followed << core::to_line(f) << '\n' << core::to_line(after);
    }
}

/// What stands there for a person, `fusee fix` reads, too: no `key = value` is lost.
TEST_P(Followed, IsReadByPrograms) {
    const core::Finding f = worst(GetParam().rule, bad(GetParam()));
    std::size_t written = 0, read = 0;
    for (std::size_t at = f.suggestion.text().find(" = "); at != std::string::npos; at = f.suggestion.text().find(" = ", at + 3)) ++written;
    for (const core::Changes& changes : f.suggestion.changes()) read += changes.size();
    EXPECT_EQ(read, written) << f.suggestion.text();
}

INSTANTIATE_TEST_SUITE_P(Suggestion, Followed, testing::ValuesIn(all_cases()));

}  // namespace
}  // namespace fusee::checks
