#include <cmath>
#include <limits>

#include "fusee/core/error.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/effects/effect.h"
#include "fusee/gap_case/reference.h"
#include "gap_case/fixture.h"
#include "refused.h"
#include "subsystem/fixture.h"

// Diagnoses that a prediction refuses: what no law allows and no rig can be.
namespace fusee::subsystem {
namespace {

diagnosis::FoundEffect found(const std::string& id, const std::string& side, double value) {
    return {{id, side}, 1.0, {value, {}, ""}, {}};
}

class Possible : public fixtures::CaseFolder {
protected:
    [[nodiscard]] static std::string said(const gap_case::Case& subsystem_case, const diagnosis::Diagnosis& diagnosis) {
        try {
            diagnosis::require_possible(subsystem_case, diagnosis, "d.json");
        } catch (const core::InvalidInput& e) {
            return e.what();
        }
        return "accepted";
    }
    [[nodiscard]] std::string said(const std::vector<diagnosis::FoundEffect>& effects) const {
        diagnosis::Diagnosis diagnosis;
        diagnosis.effects = effects;
        return said(gap_case::read_case(folder_), diagnosis);
    }
};

TEST_F(Possible, EachSizeHasItsRange) {  // on the paper's rig, whose springs reach 2 Nm instead of 2.6 Nm
    EXPECT_EQ(said({found("se.radius", "both", -0.02)}), "d.json: effects[0]: se.radius: -0.02 (allowed: -0.006 to 0.006 m)");
    EXPECT_NE(said({found("gear.coulomb", "agonist", -1e308)}).find("-1e+308 (allowed: 0 to 0.384615 Nm)"), std::string::npos);
    EXPECT_NE(said({found("gear.load_friction", "both", -5.0)}).find("-5 (allowed: -0.9 to 1.5"), std::string::npos);
    EXPECT_NE(said({found("gear.coulomb", "both", std::nan(""))}).find("allowed: 0 to 0.384615"), std::string::npos);
    for (const effects::Effect& effect : effects::effects_on(gap_case::reference_of(gap_case::read_case(folder_).rig)))
        for (const effects::EffectParameter& size : {effect.parameters.front()}) {
            const char* side = effect.sided ? "both" : "none";
            EXPECT_EQ(said({found(effect.id, side, size.allowed.low)}), "accepted") << effect.id;
            EXPECT_EQ(said({found(effect.id, side, size.allowed.high)}), "accepted") << effect.id;
            EXPECT_NE(said({found(effect.id, side, size.allowed.low - 0.01 * size.allowed.width())}), "accepted") << effect.id;
            EXPECT_NE(said({found(effect.id, side, size.allowed.high + 0.01 * size.allowed.width())}), "accepted") << effect.id;
        }
}

TEST_F(Possible, FurtherParametersUnitsAndNamesAreChecked) {
    diagnosis::FoundEffect stop = found("joint.stop", "none", 1.0);
    stop.extra = {{"k_s", 60.0}, {"zeta", 0.5}};
    EXPECT_EQ(said({stop}), "accepted");
    stop.extra = {{"k_s", -1e300}};
    EXPECT_NE(said({stop}).find("effects[0]: joint.stop: k_s: -1e+300 (allowed: 2.30769 to 384.615 Nm/rad)"), std::string::npos)
        << said({stop});
    stop.extra = {{"stiffness", 60.0}};
    EXPECT_NE(said({stop}).find("extra: stiffness (allowed: k_s, zeta)"), std::string::npos) << said({stop});
    diagnosis::FoundEffect radius = found("se.radius", "both", 0.5);
    radius.parameter = {0.005, {}, "mm"};
    EXPECT_NE(said({radius}).find("unit: mm (allowed: m)"), std::string::npos) << said({radius});
    EXPECT_NE(said({found("gear.grit", "both", 0.1)}).find("gear.grit"), std::string::npos);
}

TEST_F(Possible, AnEffectStandsOnceOnASide) {
    EXPECT_EQ(said({found("gear.coulomb", "agonist", 0.1), found("gear.coulomb", "antagonist", 0.1)}), "accepted");
    EXPECT_NE(said({found("gear.coulomb", "both", 0.1), found("se.rate", "both", 0.1), found("gear.coulomb", "both", 0.1)})
                  .find("effects[2]: gear.coulomb on both again"),
              std::string::npos);
}

TEST_F(Possible, BuildParametersAreKnownAndCanBeBuilt) {
    const gap_case::Case subsystem_case = gap_case::read_case(folder_);
    diagnosis::Diagnosis diagnosis;
    diagnosis.build = {{"K_SE radius agonist", {1e-5, {}, "m"}}};
    EXPECT_EQ(said(subsystem_case, diagnosis), "accepted");
    EXPECT_EQ(diagnosis::predict(subsystem_case, diagnosis, subsystem_case.rows).size(), subsystem_case.rows.size());
    diagnosis.build[0].second.value = -0.5;
    EXPECT_NE(
        field_refused([&] { return diagnosis::predict(subsystem_case, diagnosis, subsystem_case.rows); }).find("shortest arm of K_SE"),
        std::string::npos);
    for (const char* radius : {"joint radius", "capstan radius"}) {
        diagnosis.build = {{std::string(radius) + " antagonist", {-1.5, {}, "1"}}};
        EXPECT_NE(field_refused([&] {
                      return diagnosis::predict(subsystem_case, diagnosis, subsystem_case.rows);
                  }).find("antagonist: " + std::string(radius)),
                  std::string::npos);
    }
    diagnosis.build = {{"capstan radius", {1e-3, {}, "1"}}};  // of both sides, as older versions wrote it
    EXPECT_NE(said(subsystem_case, diagnosis).find("build: capstan radius (allowed: "), std::string::npos);
    diagnosis.build = {{"joint inertia", {-2.0, {}, "1"}}};
    EXPECT_NE(field_refused([&] { return diagnosis::predict(subsystem_case, diagnosis, subsystem_case.rows); }).find("joint inertia"),
              std::string::npos);
    diagnosis.build = {{"grease", {1.0, {}, "1"}}};
    EXPECT_NE(said(subsystem_case, diagnosis).find("d.json: build: grease (allowed: gear load friction agonist"), std::string::npos);
    diagnosis::Diagnosis friction;
    friction.effects = {found("gear.coulomb", "both", -0.1)};
    EXPECT_NE(field_refused([&] { return diagnosis::predict(subsystem_case, friction, subsystem_case.rows); }).find("gear friction [Nm]"),
              std::string::npos);
    friction.effects = {found("sensor.joint_offset", "none", 1e308)};
    EXPECT_NE(
        field_refused([&] { return diagnosis::predict(subsystem_case, friction, subsystem_case.rows); }).find("zero of the joint encoder"),
        std::string::npos);
}

TEST_F(Possible, APredictionEnds) {
    const gap_case::Case subsystem_case = gap_case::read_case(folder_);
    gap_case::Rows inputs;
    inputs.log = {{-1e6, 0.5, 0.5, 0.0}, {1e6, 0.5, 0.5, 0.0}};
    EXPECT_EQ(field_refused([&] { return diagnosis::predict(subsystem_case, {}, inputs); }), "experiments.log");
}

TEST(PossibleSubsystem, EffectsAndBuildParametersStayWhereAFitMayGo) {
    const Case subsystem_case = fixtures::measure({{"agonist", fixtures::Motor{}}}, 1);
    const auto field = [&](const std::vector<diagnosis::FoundEffect>& effects,
                           std::vector<std::pair<std::string, diagnosis::Parameter>> build) {
        diagnosis::Diagnosis diagnosis;
        diagnosis.effects = effects;
        diagnosis.build = std::move(build);
        return field_refused([&] { return predict(subsystem_case, diagnosis, subsystem_case); });
    };
    EXPECT_EQ(field({found("gear.coulomb", "agonist", 0.02)}, {}), "accepted");
    EXPECT_EQ(field({found("gear.coulomb", "agonist", -1e308)}, {}), "effects: gear.coulomb");
    EXPECT_EQ(field({found("gear.coulomb", "agonist", 0.02), found("gear.coulomb", "agonist", 0.02)}, {}), "effects: gear.coulomb");
    EXPECT_EQ(field({}, {{"gear_load_friction agonist", {5.0, {}, ""}}}), "build: gear_load_friction agonist");
    diagnosis::FoundEffect more = found("gear.coulomb", "agonist", 0.02);
    more.extra = {{"speed", 1.0}};
    EXPECT_EQ(field({more}, {}), "effects: gear.coulomb: extra");
    more = found("gear.coulomb", "agonist", 0.02);
    more.parameter.unit = "Ncm";
    EXPECT_EQ(field({more}, {}), "effects: gear.coulomb: unit");
}

}  // namespace
}  // namespace fusee::subsystem
