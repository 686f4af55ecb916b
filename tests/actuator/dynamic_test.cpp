#include <gtest/gtest.h>

#include <cstdio>

#include "actuator/dynamic_joint.h"
#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/stick_slip.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"
#include "with_law.h"

namespace fusee::actuator {
namespace {

constexpr double kRadius = 0.03;

Actuator with_springs(const core::Outcome<spring::SpringLawPtr>& law, const spring::FrictionLaw& gear, double capstan_radius = kRadius) {
    return {.law = *law,
            .capstan_radius = capstan_radius,
            .joint_radius = kRadius,
            .gear_friction = gear,
            .least_torque = 0.1,
            .peak_torque = 1.0,
            .overdrive_torque = 1.5};
}

Actuator paper() {
    const spring::StictionLawOptions options{.k = 0.225, .u = 0.0012, .c = 0.265, .mu = kMu, .start_torque = 0.6, .end_torque = 2.21};
    return with_springs(spring::make_stiction_law(options), spring::FrictionLaw::proportional(kMu));
}

Actuator low_load() {
    const spring::StictionLawOptions options{.k = 0.42, .u = 0.03, .c = 0.05, .mu = kMu, .start_torque = 0.12, .end_torque = 1.0};
    return with_springs(spring::make_stiction_law(options), spring::FrictionLaw::proportional(kMu));
}

Actuator first_prototype() {
    const auto law =
        spring::make_pair_law(spring::make_polynomial({0.0, 0.10, 0.02}), spring::make_polynomial({0.0, 0.25, 0.03}), 0.08, 1.65);
    return with_springs(law, spring::FrictionLaw::proportional(kMu));
}

Actuator exponential() {
    const auto law = spring::make_pair_law(spring::make_exponential(0.2, 0.8, 0.0), spring::make_exponential(0.15, 1.0, 0.0), 0.05, 4.0);
    return with_springs(law, spring::FrictionLaw::proportional(kMu));
}

/// Capstan and joint of two radii, friction that does not vanish with the load.
Actuator unequal() {
    const auto law = spring::make_pair_law(spring::make_polynomial({0.0, 0.3, 0.05}), spring::make_polynomial({0.0, 0.2, 0.02}), 0.05, 4.0);
    return with_springs(law, spring::FrictionLaw::affine(0.06, 0.25), 0.02);
}

/// One actuator, pushed with what release_test chooses or, where the laws end before that, also with no more than they bear: beyond its end
/// a spring goes on straight, in the simulation as on the path.
struct DynamicCase {
    const char* name;
    Actuator (*make)();
    double tau;
    double push;          ///< [Nm]; 0: release_test's choice
    double linear_error;  ///< of the linear width, relative to the simulated one: what P(3)-(4) would be off by
};

class DynamicTest : public testing::TestWithParam<DynamicCase> {};

/// The path is the limit of slow motion. What separates the two: inertia and the hand's damping (halving the speed halves it), and the
/// capstan's deflection before it slides, 2e-4 of the narrowest width's share and 1e-3 at most.
TEST_P(DynamicTest, ProtocolAgreesAndLinearDoesNot) {
    const DynamicCase& given = GetParam();
    const Actuator actuator = given.make();
    const Joint joint = joint_of(actuator);
    const ReleaseReading path = release_test(joint, given.tau, {.push_torque = given.push});
    const DynamicReading time = dynamic_release_test(joint, given.tau, path.push_torque);
    const DeadBand band = dead_band(actuator, given.tau);
    std::printf("%-16s tau %.2f push %.3f Nm: linear %.4f extreme %.4f protocol %.4f dynamic %.4f rad, off by %+.2f %% (linear %+.0f %%)\n",
                given.name, given.tau, path.push_torque, band.linear, band.exact_width, path.width(), time.width(),
                100.0 * (path.width() / time.width() - 1.0), 100.0 * (band.linear / time.width() - 1.0));
    EXPECT_NEAR(path.width() / time.width(), 1.0, 0.03);
    EXPECT_NEAR(path.q_high, time.q_high, 0.03 * time.width());
    EXPECT_NEAR(path.q_low, time.q_low, 0.03 * time.width());
    EXPECT_LT(time.presliding, 0.002 * time.width());
    EXPECT_NEAR(band.linear / time.width(), 1.0 + given.linear_error, 0.03 * (1.0 + given.linear_error));
    EXPECT_GT(std::abs(given.linear_error), 0.15);
}

INSTANTIATE_TEST_SUITE_P(FiveActuators, DynamicTest,
                         testing::Values(DynamicCase{"paper", paper, 1.0, 0.0, 0.233}, DynamicCase{"paper_weak", paper, 1.0, 0.328, 9.71},
                                         DynamicCase{"first_prototype", first_prototype, 0.5, 0.0, 0.97},
                                         DynamicCase{"exponential", exponential, 1.0, 0.0, 0.213},
                                         DynamicCase{"low_load", low_load, 0.35, 0.0, 0.165},
                                         DynamicCase{"low_load_weak", low_load, 0.35, 0.088, 11.75},
                                         DynamicCase{"unequal", unequal, 0.5, 0.0, 0.212}),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace fusee::actuator
