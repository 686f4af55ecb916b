#include <gtest/gtest.h>

#include <array>

#include "fusee/effects/effect.h"
#include "fusee/joint_model/signals.h"
#include "joint_model/fixture.h"

// A capstan without springs breaks away where |tau - L| = c + mu L + b L^2, each in its closed form.
namespace fusee::joint_model {
namespace {

using namespace fixtures;

const double kMu = straight_rig().gear_load_friction;

double load(const BuiltRig& rig, const char* side, bool backdrive, double torque) {
    gap_case::Rows rows;
    rows.breakaway = {{side, backdrive, torque, 0.0}};
    return predict_experiment(rig, rows, {}, gap_case::Experiment::kBreakAway).front();
}

/// An effect on the agonist, and the loads of both directions with it.
struct Known {
    const char* id;
    std::vector<double> values;
    double (*backdrive)(double torque, double value);
    double (*drive)(double torque, double value);
};
void PrintTo(const Known& known, std::ostream* out) { *out << known.id; }

class BreakAwayLaw : public ::testing::TestWithParam<Known> {};

TEST_P(BreakAwayLaw, IsTheClosedFormOnItsSideAndLeavesTheOtherAlone) {
    const Known& known = GetParam();
    const BuiltRig rig = built(straight_rig(), [&](BuiltRig& r) {
        effects::apply_effect(effects::find_effect(known.id), {known.id, "agonist"}, known.values, r);
    });
    for (const double torque : {0.2, 0.7, 1.3}) {
        EXPECT_NEAR(load(rig, "agonist", true, torque), known.backdrive(torque, known.values[0]), 1e-6 * torque);
        EXPECT_NEAR(load(rig, "agonist", false, torque), known.drive(torque, known.values[0]), 1e-6 * torque);
        EXPECT_NEAR(load(rig, "antagonist", true, torque), torque / (1.0 - kMu), 1e-12);
        EXPECT_NEAR(load(rig, "antagonist", false, torque), torque / (1.0 + kMu), 1e-12);
    }
}

double root(double square, double linear, double constant) {  // of square L^2 + linear L = constant, the one that goes on to square = 0
    return 2.0 * constant / (linear + std::sqrt(linear * linear + 4.0 * square * constant));
}

const std::vector<Known> kKnown{
    {"gear.load_friction",
     {0.2},
     [](double t, double e) { return t / (1.0 - kMu * (1.0 + e)); },
     [](double t, double e) { return t / (1.0 + kMu * (1.0 + e)); }},
    {"gear.coulomb",
     {0.05},
     [](double t, double c) { return (t + c) / (1.0 - kMu); },
     [](double t, double c) { return (t - c) / (1.0 + kMu); }},
    {"gear.stribeck",
     {0.5, 0.05},
     [](double t, double s) { return t / (1.0 - kMu * (1.0 + s)); },
     [](double t, double s) { return t / (1.0 + kMu * (1.0 + s)); }},
    {"gear.asymmetry",
     {0.3},
     [](double t, double a) { return t / (1.0 - kMu * (1.0 - a)); },
     [](double t, double a) { return t / (1.0 + kMu * (1.0 + a)); }},
    {"gear.load_quadratic",
     {0.04},
     [](double t, double b) { return root(-b, 1.0 - kMu, t); },
     [](double t, double b) { return root(b, 1.0 + kMu, t); }},
    {"gear.viscous", {0.3}, [](double t, double) { return t / (1.0 - kMu); }, [](double t, double) { return t / (1.0 + kMu); }},
    {"sensor.torque_scale",
     {-0.1},
     [](double t, double e) { return t * (1.0 + e) / (1.0 - kMu); },
     [](double t, double e) { return t * (1.0 + e) / (1.0 + kMu); }},
    {"motor.saturation",
     {0.6},
     [](double t, double most) { return std::min(t, most) / (1.0 - kMu); },
     [](double t, double most) { return std::min(t, most) / (1.0 + kMu); }},
};

INSTANTIATE_TEST_SUITE_P(Effects, BreakAwayLaw, ::testing::ValuesIn(kKnown), [](const auto& test) {
    std::string name = test.param.id;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
});

TEST(PredictBreakAway, AMotorBelowItsConstantFrictionLiftsNothing) {
    const BuiltRig rig = built(straight_rig(), [](BuiltRig& r) { r.sides[0].gear.coulomb = 0.3; });
    EXPECT_EQ(load(rig, "agonist", false, 0.2), 0.0);
}

TEST(PredictBreakAway, EverySizeThatIsAllowedGivesALoadEvenWhereAGearLocksItself) {
    for (const effects::Effect& effect : effects::effect_library())
        for (const double size : {effect.parameters[0].allowed.low, effect.parameters[0].allowed.high}) {
            std::vector<double> values{size};
            for (std::size_t k = 1; k < effect.parameters.size(); ++k) values.push_back(effect.parameters[k].at_first);
            const BuiltRig rig = built(straight_rig(), [&](BuiltRig& r) { effect.apply(r, 0, values); });
            for (const bool backdrive : {true, false})
                EXPECT_TRUE(std::isfinite(load(rig, "agonist", backdrive, 1.5))) << effect.id << size;
        }
}

}  // namespace
}  // namespace fusee::joint_model
