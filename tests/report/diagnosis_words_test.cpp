#include <algorithm>
#include <cmath>

#include "diagnosis/words.h"
#include "fusee/report/diagnosis.h"
#include "page_structure.h"
#include "report/diagnosis_fixture.h"

namespace fusee::report {
namespace {

TEST(DiagnosisWords, SmallProbabilitiesHaveABound) {
    EXPECT_EQ(chance(7e-40), "< 0.001");
    EXPECT_EQ(chance(0.12345), "0.123");
    EXPECT_EQ(chance(diagnosis::kNoFigure), "\u2013");
}

TEST(DiagnosisWords, LengthsAreReadInMillimetres) {
    const diagnosis::Parameter mm = for_reading({-2.1e-4, {-2.6e-4, -1.6e-4}, "m"});
    EXPECT_EQ(mm.unit, "mm");
    EXPECT_DOUBLE_EQ(mm.value, -0.21);
    EXPECT_DOUBLE_EQ(mm.ci95.low, -0.26);
    EXPECT_EQ(for_reading({0.05, {}, "Nm"}).value, 0.05);
}

TEST(DiagnosisWords, ColumnsLoseTheirUnitToBrackets) {
    EXPECT_EQ(column_name("q_high_rad"), "q high [rad]");
    EXPECT_EQ(column_name("cocontraction_Nm"), "co-contraction [Nm]");
    EXPECT_EQ(column_name("v_m_s"), "v [m/s]");
    EXPECT_EQ(column_name("joint_viscous_Nms"), "joint viscous [Nms]");
    EXPECT_EQ(column_name("torque_enable"), "torque enable");
    EXPECT_EQ(column_name(""), "");
    EXPECT_EQ(experiment_name("dead_band"), "dead-band");
    EXPECT_EQ(experiment_name("force_loop"), "force loop");
}

TEST(DiagnosisWords, EveryIdOfTheFormatHasAMeaning) {
    for (const char* id : {"gear.load_friction",
                           "gear.coulomb",
                           "gear.stribeck",
                           "gear.viscous",
                           "gear.backlash",
                           "gear.asymmetry",
                           "gear.load_quadratic",
                           "motor.saturation",
                           "joint.coulomb",
                           "joint.viscous",
                           "joint.stop",
                           "joint.gravity",
                           "cable.tension_friction",
                           "cable.stretch",
                           "se.rate",
                           "pe.rate",
                           "se.radius",
                           "pe.radius",
                           "se.preload",
                           "pe.preload",
                           "se.hysteresis",
                           "pe.hysteresis",
                           "pe.bottoming",
                           "sensor.torque_scale",
                           "sensor.joint_offset",
                           "loop.delay",
                           "loop.gain",
                           "element.presliding",
                           "element.backlash",
                           "element.asymmetry",
                           "element.viscous",
                           "element.stribeck",
                           "element.load"})
        EXPECT_FALSE(meaning(id).empty()) << id;
    EXPECT_EQ(meaning("gear.moonlight"), "");
    expect_all(law("gear.stribeck"), {"exp(-(v/v_s)^2)", "gear.load_friction"});
    EXPECT_EQ(law("loop.gain"), "") << "of subsystem cases";
}

TEST(DiagnosisWords, TheVerdictIsASentence) {
    diagnosis::Diagnosis d = diagnosis();
    expect_all(verdict_sentence(d), {"2 effects", "gear.coulomb (agonist) and se.radius (both)"});
    EXPECT_DOUBLE_EQ(verdict_probability(d), 0.934) << "of the less certain one";
    d.effects.resize(1);
    expect_all(verdict_sentence(d), {"an effect", "gear.coulomb (agonist)."});
    d.verdict = diagnosis::VerdictKind::kAmbiguous;
    d.alternatives = {{{{"gear.coulomb", "agonist"}}, 0.5}, {{{"joint.coulomb", "none"}}, 0.45}, {{}, 0.001}};
    expect_all(verdict_sentence(d), {"gear.coulomb (agonist); or joint.coulomb."});
    d.verdict = diagnosis::VerdictKind::kUnknown;
    expect_all(verdict_sentence(d), {"dead-band, co-contraction 0.12 to 0.5 Nm, agonist, push up"});
    EXPECT_TRUE(std::isnan(verdict_probability(d))) << "a ranking within the library says nothing about other effects";
    d.verdict = diagnosis::VerdictKind::kNone;
    d.ranking = {{{}, 0.0, 0.97, 300.0, 1.0, {}}};
    EXPECT_DOUBLE_EQ(verdict_probability(d), 0.97);
}

TEST(DiagnosisWords, AFitOfAllParametersIsASentence) {
    diagnosis::Diagnosis d = diagnosis();
    EXPECT_EQ(absorption_sentence(d), "");
    d.effects.resize(1);
    d.absorption = diagnosis::Absorption{{{"link_mass_kg", 0.2, 12.0, 0.001, "kg"}, {"rate", -0.1, -2.0, 0.0, "1"}}, 1.1, 3.3};
    EXPECT_EQ(absorption_sentence(d),
              "A fit of all parameters explains the log as well (1.1 sigma) but is 3.1 times worse on the rows held out (3.3 sigma, not "
              "1.1): it hides gear.coulomb (agonist) in link_mass_kg (+12 tolerances).");
    expect_all(diagnosis_text(d), {"  A fit of all parameters explains the log as well"});
    d.absorption->after = 5.0;
    d.absorption->moved = {{"zero_m", 0.002, diagnosis::kNoFigure, 0.001, "m"}, {"other_m", 1.01, diagnosis::kNoFigure, 1.0, "m"}};
    const std::string partly =
        "A fit of all parameters leaves 5 sigma of the log, not 1, and is 3.1 times worse on the rows held out (3.3 sigma, not 1.1): it ";
    EXPECT_EQ(absorption_sentence(d), partly + "hides a part of gear.coulomb (agonist) in zero_m (2 mm for 1 mm).");
    d.absorption->moved.erase(d.absorption->moved.begin());
    EXPECT_EQ(absorption_sentence(d), partly + "cannot hide gear.coulomb (agonist).");
    d.absorption = diagnosis::Absorption{{{"gear.coulomb", 0.05, 9.0, 0.05, "Nm"}}, 1.04, 1.06};
    EXPECT_EQ(absorption_sentence(d),
              "A fit of all parameters explains the log as well (1 sigma) and is as good on the rows held out (1.1 sigma): it finds "
              "gear.coulomb (agonist), too.");
}

TEST(DiagnosisWords, WhatHoldsOnAnotherCaseIsALineForEachCause) {
    diagnosis::Diagnosis d = diagnosis();
    EXPECT_TRUE(against_lines(d).empty());
    diagnosis::Against& on = d.against.emplace();
    on.case_name = "tuesday";
    on.causes = {{{"se.radius", "both"}, {-2e-4, {-3e-4, -1e-4}, "m"}, {1e-4, {0.0, 2e-4}, "m"}, diagnosis::Survival::kDiffers},
                 {{"gear.asymmetry", "none"}, {0.301, {0.2, 0.4}, "1"}, {0.25, {0.2, 0.3}, "1"}, diagnosis::Survival::kAgrees},
                 {{"joint.stop", "none"}, {0.5, {0.4, 0.6}, "rad"}, {NAN, {NAN, NAN}, "rad"}, diagnosis::Survival::kOpen}};
    on.before = 9.0;
    on.carried = 2.5;
    on.refitted = 1.25;
    on.own = 1.125;
    EXPECT_EQ(against_lines(d),
              (std::vector<std::string>{"against tuesday: se.radius (both): -0.2 mm here, 0.1 mm there (95 %: 0 to 0.2): differs",
                                        "against tuesday: gear.asymmetry: 30.1 % here, 25 % there (95 %: 20 to 30): agrees",
                                        "against tuesday: joint.stop: 0.5 rad here, not measured there: open",
                                        "gap of tuesday: 9 sigma, 2.5 with these causes as they are, 1.25 with their sizes fitted there, "
                                        "1.12 with its own diagnosis (none: no effect)"}));
}

TEST(DiagnosisText, HoldsWhereWhichAndHowFar) {
    expect_all(diagnosis_text(diagnosis()),
               {"open-07: ", "gear.coulomb (agonist): 0.0512 Nm (95 %: 0.0473 to 0.0551 Nm), probability 0.981",
                "se.radius (both): -0.21 mm", "62 %", "9.12 \u2192 1.04 sigma, noise floor 1",
                "9.31 \u2192 1.06 sigma (95 %: 0.97 to 1.17)", "next: Hold the agonist's motor", "- Leaving out the time log"});
}

TEST(DiagnosisText, StaysShort) {
    diagnosis::Diagnosis d = diagnosis();
    d.effects.resize(9, d.effects.front());
    d.where.resize(20, d.where.front());
    d.remarks.resize(50, "one more");
    const std::string text = diagnosis_text(d);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), kMostDiagnosisLines);
    expect_all(text, {"5 more effects", "more remarks"});
    EXPECT_FALSE(holds(text, "nan"));
}

TEST(DiagnosisText, AnEmptyDiagnosisIsTwoLines) {
    const std::string text = diagnosis_text({});
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
    EXPECT_EQ(text.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace fusee::report
