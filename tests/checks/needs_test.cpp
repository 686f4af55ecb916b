#include <gtest/gtest.h>

#include <map>
#include <set>

#include "checks/fixture.h"

// Known: a rule that applies and lacks data is not judged and names the keys; with the data it is judged; where it does not apply it
// reports nothing.
namespace fusee::checks {
namespace {

void state_all(Fixture& b) {
    spring::BaseSpring& s = b.spring;
    s.max_load = 300.0;
    s.active_coils = 8.0;
    s.free_length = 60.0 * kMm;
    s.hand = b.part.cam.rotation_sign > 0 ? spring::Hand::kLeft : spring::Hand::kRight;
    s.rod_diameter = 4.0 * kMm;
    s.cycles = 1e5;
}

Fixture stated_spool() {
    Fixture b = spool();
    state_all(b);
    return b;
}

Fixture stated_pusher() {
    Fixture b = pusher();
    state_all(b);
    return b;
}

Fixture stated_rim() {
    Fixture b = pusher();
    b.part.cam.options.family = cam::Family::kRoller;
    b.part.cam.options.roller = {
        .radius = 8.0 * kMm, .base_radius = 20.0 * kMm, .width = 5.0 * kMm, .contact_modulus = 2e9, .max_pressure = 1e9};
    state_all(b);
    return b;
}

using Unstate = void (*)(Fixture&);
const std::map<std::string, Unstate> kUnstate = {
    {"spring.wire_mm", [](Fixture& b) { b.spring.wire_diameter = 0.0; }},
    {"spring.coil_mm", [](Fixture& b) { b.spring.coil_diameter = 0.0; }},
    {"spring.active_coils", [](Fixture& b) { b.spring.active_coils = 0.0; }},
    {"spring.free_length_mm", [](Fixture& b) { b.spring.free_length = 0.0; }},
    {"spring.tensile_strength_MPa", [](Fixture& b) { b.spring.tensile_strength = 0.0; }},
    {"spring.rod_mm", [](Fixture& b) { b.spring.rod_diameter = 0.0; }},
    {"spring.cycles", [](Fixture& b) { b.spring.cycles = 0.0; }},
    {"spring.hand", [](Fixture& b) { b.spring.hand = spring::Hand::kUnknown; }},
    {"spring.max_angle_rad", [](Fixture& b) { b.spring.max_state = 0.0; }},
    {"spring.max_travel_mm", [](Fixture& b) { b.spring.max_state = b.spring.free_length = 0.0; }},
    {"spring.max_torque_Nm", [](Fixture& b) { b.spring.max_load = 0.0; }},
    {"spring.max_force_N", [](Fixture& b) { b.spring.max_load = 0.0; }},
    {"roller.max_pressure_MPa", [](Fixture& b) { b.part.cam.options.roller.max_pressure = 0.0; }},
    {"roller.contact_modulus_MPa", [](Fixture& b) { b.part.cam.options.roller.contact_modulus = 0.0; }},
};

bool is_not_judged(const core::Findings& findings) {
    return findings.size() == 1 && findings.front().severity == core::Severity::kNotJudged;
}

/// Rules for a roller look at rollers only, and those for a cable at cables only.
bool has_family(const Rule& rule, const Fixture& b) {
    const bool roller = b.part.cam.has_roller();
    return roller == (rule.group() == "roller");
}

/// Runs the rule on a fixture with all data, then without `need`. @returns whether the rule needs it there
bool expect_need(const Rule& rule, const Need& need, Fixture b) {
    b.part.options.hub.lock = solid::HubLock::kKeyway;
    if (!has_family(rule, b) || rule.run(b.design()).empty()) return false;
    EXPECT_EQ(core::count(rule.run(b.design()), core::Severity::kNotJudged), 0u) << rule.id;
    kUnstate.at(need.key)(b);
    if (need.stated(b.design())) return false;
    const core::Findings without = rule.run(b.design());
    EXPECT_TRUE(is_not_judged(without)) << rule.id << " without " << need.key;
    if (!is_not_judged(without)) return true;
    const core::Finding& f = without.front();
    EXPECT_EQ(f.rule, rule.id);
    EXPECT_NE(f.suggestion.text().find(need.text(cam::to_string(b.part.cam.kind))), std::string::npos) << core::to_line(f);
    EXPECT_TRUE(std::isnan(f.measured) && std::isnan(f.allowed)) << rule.id;
    EXPECT_EQ(f.what, rule.title);
    EXPECT_FALSE(core::is_broken(f));
    return true;
}

TEST(Needs, EachIsNamedByItsRuleWhereItIsMissing) {
    for (const Rule& rule : rules())
        for (const Need& need : rule.needs) {
            bool needed = false;
            for (const auto fixture : {stated_spool, stated_pusher, stated_rim}) needed = expect_need(rule, need, fixture()) || needed;
            EXPECT_TRUE(needed) << rule.id << ": no fixture lacks " << need.key;
        }
}

TEST(Needs, RulesThatTheProfileLeavesOpenDeclareThem) {
    std::set<std::string> with;
    for (const Rule& rule : rules())
        if (!rule.needs.empty()) with.insert(rule.id);
    for (const char* id : {"spring.stress", "spring.fatigue", "spring.buckling", "spring.load", "spring.rate", "spring.surge",
                           "roller.contact_pressure", "assembly.leg_width"})
        EXPECT_TRUE(with.count(id)) << id;
}

TEST(Needs, ARuleThatDoesNotApplyIsSilent) {
    Fixture torsion = spool(), compression = pusher();
    torsion.spring.free_length = torsion.spring.coil_diameter = 0.0;
    compression.spring.max_state = compression.spring.active_coils = 0.0;
    EXPECT_TRUE(run_rule("spring.buckling", torsion).empty()) << "a torsion spring does not buckle";
    EXPECT_TRUE(run_rule("spring.torsion_angle", compression).empty());
    EXPECT_TRUE(run_rule("assembly.leg_width", compression).empty()) << "no slot";
    torsion.part.options.hub.lock = solid::HubLock::kPlain;
    EXPECT_TRUE(run_rule("shaft.key_pressure", torsion).empty()) << "no keyway";
}

TEST(Needs, FewStatedCyclesNeedNothing) {
    Fixture b = stated_spool();
    b.spring.cycles = 100.0;
    EXPECT_TRUE(run_rule("spring.fatigue", b).empty());
}

TEST(Needs, EitherWayToTheTravelIsEnough) {
    Fixture b = stated_pusher();
    b.spring.max_state = 0.0;
    EXPECT_FALSE(is_not_judged(run_rule("spring.travel", b))) << "free length, coils and wire give it";
    b.spring.active_coils = 0.0;
    const core::Findings none = run_rule("spring.travel", b);
    ASSERT_TRUE(is_not_judged(none));
    EXPECT_EQ(none.front().suggestion.text(),
              "k_pe.spring.max_travel_mm (or k_pe.spring.free_length_mm and k_pe.spring.active_coils and k_pe.spring.wire_mm)");
}

TEST(Needs, SeveralMissingKeysAreAllNamed) {
    Fixture b = stated_spool();
    b.spring.wire_diameter = b.spring.tensile_strength = 0.0;
    EXPECT_EQ(worst("spring.stress", b).suggestion.text(),
              "k_se.spring.wire_mm and k_se.spring.tensile_strength_MPa (or k_se.spring.wire_class)");
}

}  // namespace
}  // namespace fusee::checks
