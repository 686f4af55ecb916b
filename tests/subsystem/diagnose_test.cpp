#include <gtest/gtest.h>

#include "fusee/core/error.h"
#include "long_form.h"
#include "subsystem/fixture.h"

namespace fusee::subsystem {
namespace {

using fixtures::Element;
using fixtures::measure;
using fixtures::Motor;
using fixtures::names_of;
using fixtures::says;
using fixtures::Servo;

struct ElementCase {
    Element element;
    const char* effects;
    double size;  ///< of the first effect named
    bool preloads = false;
};

// Known: what was put in is named, its interval holds the size that was put in (to a hundredth of it for the sampling of the stroke), and
// nothing else is.
TEST(DiagnoseSubsystem, NamesWhatTheElementHas) {
    const ElementCase cases[] = {
        {{}, "", 0.0},
        {{.deflection = 0.001}, "element.presliding", 0.001},
        {{.backlash = 0.002, .rows = 800}, "element.backlash", 0.002},
        {{.asymmetry = 0.15}, "element.asymmetry", 0.15},
        {{.viscous = 4000.0}, "element.viscous", 4000.0},
        {{.stribeck = 0.4, .stribeck_speed = 0.02}, "element.stribeck", 0.4},
        {{.load = 0.8}, "element.load", 0.8, true},
        {{.deflection = 0.001, .backlash = 0.002}, "element.backlash, element.presliding", 0.0},
        {{.deflection = 0.001, .backlash = 0.002, .asymmetry = 0.15}, "element.asymmetry, element.backlash, element.presliding", 0.0},
    };
    unsigned seed = 1;
    for (const ElementCase& c : cases) {
        const diagnosis::Diagnosis d = diagnose(measure(c.element, seed++, c.preloads), {.jobs = 1, .progress = {}});
        EXPECT_EQ(names_of(d), c.effects);
        EXPECT_EQ(d.verdict, *c.effects == '\0' ? diagnosis::VerdictKind::kNone : diagnosis::VerdictKind::kIdentified) << c.effects;
        // A rigid play lets the force jump between two rows: a row near each jump
        // is told wrong by any model, by up to 50 sigma here.
        const bool jumps = c.element.backlash > 0.0 && c.element.deflection == 0.0;
        EXPECT_EQ(says(d, "at the floor"), !jumps) << c.effects;
        EXPECT_LT(d.gap.heldout_after, jumps ? 6.0 : 1.2) << c.effects;  // sigma; the noise alone is 1
        if (c.size == 0.0 || d.effects.size() != 1) continue;
        EXPECT_GT(d.gap.heldout_before, 1.5 * d.gap.heldout_after) << c.effects;
        const diagnosis::Parameter& p = d.effects.front().parameter;
        EXPECT_LT(p.ci95.low, 1.01 * c.size) << c.effects;
        EXPECT_GT(p.ci95.high, 0.99 * c.size) << c.effects;
        EXPECT_NEAR(p.value, c.size, 0.1 * c.size) << c.effects;
    }
}

TEST(DiagnoseSubsystem, SaysThatALoadCannotBeSeenWithoutPreloads) {
    EXPECT_TRUE(says(diagnose(measure(Element{}, 3), {.jobs = 1, .progress = {}}), "element.load cannot be seen here"));
}

TEST(DiagnoseSubsystem, NamesWhatTheServoHas) {
    const std::vector<std::pair<Servo, const char*>> cases{{{}, ""},
                                                           {{.coulomb = 0.01, .load_friction = 0.3}, "gear.load_friction"},
                                                           {{.coulomb = 0.01, .load_quadratic = 1.0}, "gear.load_quadratic"},
                                                           {{.delay = 0.03}, "loop.delay"}};
    unsigned seed = 20;
    for (const auto& [servo, effects] : fixtures::some_of(cases, 2)) {
        const diagnosis::Diagnosis d = diagnose(measure(servo, seed++), {.jobs = 1, .progress = {}});
        EXPECT_EQ(names_of(d), effects);
        EXPECT_TRUE(says(d, "partly confounded"));
        if (*effects == '\0') continue;
        EXPECT_LT(d.gap.heldout_after, 0.5 * d.gap.heldout_before) << effects;
    }
}

// A gear whose directions differ and a motor that gives another torque make the same rows: both are named, neither chosen.
TEST(DiagnoseSubsystem, NamesWhatTheMotorHas) {
    struct Known {
        Motor motor;
        const char* effect;
        bool ambiguous;
        double size;
    };
    const Known cases[] = {{{}, "", false, 0.0},
                           {{.constant = 0.04}, "gear.coulomb agonist", false, 0.04},
                           {{.quadratic = 0.08}, "gear.load_quadratic agonist", false, 0.08},
                           {{.asymmetry = 0.2}, "", true, 0.2},
                           {{.scale = 0.05}, "", true, 0.05}};
    unsigned seed = 40;
    for (const Known& c : cases) {
        const diagnosis::Diagnosis d = diagnose(measure({{"agonist", c.motor}}, seed++), {.jobs = 1, .progress = {}});
        if (c.ambiguous) {
            EXPECT_EQ(d.verdict, diagnosis::VerdictKind::kAmbiguous);
            std::string all = names_of(d);
            for (const diagnosis::Alternative& a : d.alternatives)
                for (const effects::Cause& cause : a.effects) all += ", " + cause.id;
            EXPECT_NE(all.find("gear.asymmetry"), std::string::npos) << all;
            EXPECT_NE(all.find("sensor.torque_scale"), std::string::npos) << all;
            continue;
        }
        EXPECT_EQ(names_of(d), c.effect);
        EXPECT_EQ(d.verdict, *c.effect == '\0' ? diagnosis::VerdictKind::kNone : diagnosis::VerdictKind::kIdentified) << c.effect;
        if (c.size > 0.0 && d.effects.size() == 1) {
            EXPECT_TRUE(d.effects.front().parameter.ci95.holds(c.size)) << c.effect;
        }
    }
}

// A scale that is far off leaves its twin beyond what is plausible: it is named, and the doubt says why it is not certain.
TEST(DiagnoseSubsystem, AMotorsTorqueScaleIsNeverCertain) {
    const diagnosis::Diagnosis d = diagnose(measure({{"agonist", {.scale = 0.2}}}, 51), {.jobs = 1, .progress = {}});
    EXPECT_EQ(d.verdict, diagnosis::VerdictKind::kAmbiguous);
    ASSERT_FALSE(d.doubts.empty());
    EXPECT_NE(d.doubts.front().find("gear.asymmetry and sensor.torque_scale"), std::string::npos) << d.doubts.front();
}

// Nothing but scatter: no effect is named.
TEST(DiagnoseSubsystem, ScatterOfAMotorIsNoEffect) {
    for (unsigned seed = 60; seed < 70; ++seed) {
        const diagnosis::Diagnosis d = diagnose(measure({{"agonist", {}}, {"antagonist", {.mu = 0.3}}}, seed), {.jobs = 1, .progress = {}});
        EXPECT_EQ(d.verdict, diagnosis::VerdictKind::kNone) << seed << ": " << names_of(d);
    }
}

TEST(DiagnoseSubsystem, OneMotorTorqueTellsNothingApart) {
    const diagnosis::Diagnosis d = diagnose(measure({{"one", {.constant = 0.1}}}, 5, {0.5}), {.jobs = 1, .progress = {}});
    EXPECT_NE(d.verdict, diagnosis::VerdictKind::kIdentified);  // six rows: too little evidence for any of the effects that could be
    EXPECT_NE(d.verdict, diagnosis::VerdictKind::kNone);
    EXPECT_GE(d.alternatives.size(), 2U);
    EXPECT_FALSE(d.next_experiment.empty());
}

TEST(DiagnoseSubsystem, NamesTheSideOfTwoMotors) {
    EXPECT_EQ(names_of(diagnose(measure({{"agonist", {}}, {"antagonist", {.constant = 0.04}}}, 6), {.jobs = 1, .progress = {}})),
              "gear.coulomb antagonist");
    EXPECT_EQ(
        names_of(diagnose(measure({{"agonist", {.constant = 0.04}}, {"antagonist", {.constant = 0.04}}}, 7), {.jobs = 1, .progress = {}})),
        "gear.coulomb both");
}

// Same: any order of rows, any number of threads.
TEST(DiagnoseSubsystem, GivesTheSameForAnyOrderAndThreads) {
    const Case subsystem_case = measure({{"agonist", {.constant = 0.04}}}, 8);
    Case turned = subsystem_case;
    Record& r = turned.records.front();
    for (auto& [name, column] : r.columns) std::reverse(column.begin(), column.end());
    for (auto& [name, column] : r.texts) std::reverse(column.begin(), column.end());
    const diagnosis::Diagnosis one = diagnose(subsystem_case, {.jobs = 1, .progress = {}}),
                               three = diagnose(subsystem_case, {.jobs = 3, .progress = {}}),
                               other = diagnose(turned, {.jobs = 1, .progress = {}});
    EXPECT_EQ(diagnosis::diagnosis_json(one), diagnosis::diagnosis_json(three));
    EXPECT_EQ(names_of(one), names_of(other));
    EXPECT_NEAR(one.effects.at(0).parameter.value, other.effects.at(0).parameter.value, 1e-6);  // sums in another order
}

TEST(DiagnoseSubsystem, RefusesAHandfulOfRows) {
    Case subsystem_case = measure({{"agonist", {}}}, 9, {0.5});
    for (auto& [name, column] : subsystem_case.records[0].columns) column.resize(4);
    for (auto& [name, column] : subsystem_case.records[0].texts) column.resize(4);
    EXPECT_THROW((void)diagnose(subsystem_case), core::InvalidInput);
}

}  // namespace
}  // namespace fusee::subsystem
