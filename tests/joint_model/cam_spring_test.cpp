#include "fusee/joint_model/cam_spring.h"

#include <gtest/gtest.h>

#include "fusee/spring/potential.h"
#include "joint_model/fixture.h"
#include "refused.h"

namespace fusee::joint_model {
namespace {

using namespace fixtures;

constexpr int kPlaces = 97;                 // no divisor of the tables' cells
constexpr double kFrom = 0.3, kUpTo = 3.6;  // [rad], within every built spring's cam
const gap_case::NominalRig kStiffening = stiffening_rig();

TEST(CamSpring, WithoutAFaultIsTheNominalCurve) {
    const NominalCams cams(kStiffening);
    const CamSpring se = cams.series({}), pe = cams.parallel({});
    for (int i = 0; i <= kPlaces; ++i) {
        const double x = kEnd * i / kPlaces;
        EXPECT_NEAR(se.torque(x), kSe.torque(x), 1e-4 * kSe.torque(kEnd));  // linear within 1/1200 of the range: 3e-7 of the end's torque
        EXPECT_NEAR(pe.torque(x), kPe.torque(x), 1e-4 * kPe.torque(kEnd));
    }
}

TEST(CamSpring, ACableCannotPushAndItsDeflectionIsTheInverseOfItsTorque) {
    const CamSpring se = NominalCams(kStiffening).series({});
    EXPECT_EQ(se.torque(-0.001), 0.0);
    EXPECT_EQ(se.torque(-3.0), 0.0);
    EXPECT_EQ(se.deflection(0.0), 0.0);
    for (const double x : {0.05, 0.7, 2.0, 3.99}) EXPECT_NEAR(se.deflection(se.torque(x)), x, 1e-9);
}

// With a constant arm r a spool has F = k r_c/r (phi_end + dx r_c/r), a cam F = k r (y_end + r dx).
TEST(CamSpring, ItsArmStaysBeyondTheEnd) {
    const NominalCams cams(kStiffening);
    constexpr double kBeyond = 0.5, kWound = 0.1, kDeeper = 0.001;  // [rad], [rad], [m]
    const double phi = std::sqrt(2.0 * kSe.energy(kEnd) / kStiffening.se_torsion_rate), y = cams.greatest_compression();
    const double lever = kSe.torque(kEnd) / (kStiffening.se_torsion_rate * phi),
                 arm = kPe.torque(kEnd) / (kStiffening.pe_compression_rate * y);
    const CamSpring se = cams.series({.rate = 0.1, .preload = kWound}), pe = cams.parallel({.rate = 0.1, .preload = kDeeper});
    EXPECT_NEAR(se.torque(kEnd + kBeyond), 1.1 * kStiffening.se_torsion_rate * lever * (phi + kWound + lever * kBeyond), 1e-6);
    EXPECT_NEAR(pe.torque(kEnd + kBeyond), 1.1 * kStiffening.pe_compression_rate * arm * (y + kDeeper + arm * kBeyond), 1e-6);
    const double stiffness = kStiffening.se_torsion_rate * lever * lever, compliance = 0.2;
    const CamSpring stretched = cams.series({.stretch = compliance});
    EXPECT_NEAR(stretched.torque(stretched.end() + 1.0) - stretched.torque(stretched.end()), stiffness / (1.0 + compliance * stiffness),
                1e-6);
}

struct Fault {
    const char* name;
    SpringBuild build;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

/// Against the exact spring of module `spring`, whose base spring has to be preloaded: its law begins at kFrom, where the base spring of a
/// case has the state z. What a longer arm adds up to there is put in by hand.
class BuiltCam : public ::testing::TestWithParam<Fault> {};

spring::PotentialPtr from(const Stiffening& law) {
    return spring::make_polynomial({law.torque(kFrom), law.a + 2.0 * law.b * kFrom, law.b});
}

TEST_P(BuiltCam, SeriesIsTheExactBuiltSpring) {
    const SpringBuild& fault = GetParam().build;
    const double state = std::sqrt(2.0 * kSe.energy(kFrom) / kStiffening.se_torsion_rate);
    const auto exact =
        spring::make_built_spring(from(kSe), {.kind = spring::BaseKind::kTorsion, .rate = kStiffening.se_torsion_rate, .preload = state},
                                  kStiffening.capstan_radius, {fault.rate, fault.radius, fault.preload});
    const CamSpring se = NominalCams(kStiffening).series(fault);
    const double begin = kFrom + fault.radius * state / kStiffening.capstan_radius;
    for (double x = begin; x < kUpTo; x += 0.0731) EXPECT_NEAR(se.torque(x) / exact->force(x - begin), 1.0, 1e-3) << x;
}

TEST_P(BuiltCam, ParallelIsTheExactBuiltSpring) {
    const SpringBuild fault{.rate = GetParam().build.rate, .radius = GetParam().build.radius, .preload = 0.01 * GetParam().build.preload};
    const double state = std::sqrt(2.0 * kPe.energy(kFrom) / kStiffening.pe_compression_rate);
    const auto exact = spring::make_built_spring(
        from(kPe), {.kind = spring::BaseKind::kCompression, .rate = kStiffening.pe_compression_rate, .preload = state},
        kStiffening.capstan_radius, {fault.rate, fault.radius, fault.preload + fault.radius * kFrom});
    const CamSpring pe = NominalCams(kStiffening).parallel(fault);
    for (double x = kFrom; x < kUpTo; x += 0.0731) EXPECT_NEAR(pe.torque(x) / exact->force(x - kFrom), 1.0, 1e-3) << x;
}

// Sizes of an effect, not of a tolerance: 3 to 20 % of the torque.
INSTANTIATE_TEST_SUITE_P(Faults, BuiltCam,
                         ::testing::Values(Fault{"stiffer", {.rate = 0.12}}, Fault{"softer", {.rate = -0.12}},
                                           Fault{"longer_arms", {.radius = 1e-3}}, Fault{"shorter_arms", {.radius = -7e-4}},
                                           Fault{"wound", {.preload = 0.15}}, Fault{"slack", {.preload = -0.15}},
                                           Fault{"all", {.rate = -0.05, .radius = 5e-4, .preload = 0.1}}),
                         [](const auto& test) { return test.param.name; });

TEST(CamSpring, AStretchedCableGivesWayByItsPullOverItsRate) {
    const double rate = 2.5;  // [Nm/rad]
    const NominalCams cams(kStiffening);
    const CamSpring firm = cams.series({}), stretched = cams.series({.stretch = 1.0 / rate});
    for (const double x : {0.2, 1.0, 2.3, 3.7}) {
        const double torque = firm.torque(x);
        EXPECT_NEAR(stretched.torque(x + torque / rate), torque, 2e-5);  // cells are wider by the stretch: 2e-5 of the end's 1.8 Nm each
    }
    EXPECT_NEAR(stretched.end(), firm.end() + kSe.torque(kEnd) / rate, 1e-5);
}

TEST(CamSpring, BoundCoilsTakeOverPastTheirCompression) {
    const double binds_at = 0.02, rate = 15.0;
    const NominalCams cams(kStiffening);
    const CamSpring free = cams.parallel({}), bound = cams.parallel({.binds_at = binds_at, .binding_rate = rate});
    for (int i = 1; i <= kPlaces; ++i) {
        const double x = kEnd * i / kPlaces, y = std::sqrt(2.0 * kPe.energy(x) / kStiffening.pe_compression_rate);
        const double more = y <= binds_at ? 0.0 : rate * (y - binds_at) / y;  // of the spring's own force
        // The kink lies within a cell: at most a quarter of 15 times what a cell's compression (0.01 rad x 17 mm) adds to 20 mm
        EXPECT_NEAR(bound.torque(x) / free.torque(x), 1.0 + more, std::abs(y - binds_at) < 4e-4 ? 0.04 : 1e-3 * (1.0 + more)) << x;
    }
    EXPECT_NEAR(cams.greatest_compression(), std::sqrt(2.0 * kPe.energy(kEnd) / kStiffening.pe_compression_rate), 1e-7);
}

// Beyond the step the state gains a share of the cable or compression that the whole cam takes from there on.
TEST(CamSpring, AStepOfTheArmsChangesTorqueAtOnceAndDeflectionFromThereOn) {
    const double a = -0.15, at = 0.5, compression = std::sqrt(2.0 / kStiffening.pe_compression_rate);
    const NominalCams cams(kStiffening);
    const CamSpring se = cams.series({.step = a, .step_at = at}), pe = cams.parallel({.step = a, .step_at = at});
    double of_step = 0.0;  // the deflection at half the spool's turn: a quarter of the energy
    while (kSe.energy(of_step) < at * at * kSe.energy(kEnd)) of_step += 1e-4;
    for (const double share : {0.1, 0.3, 0.45}) {
        EXPECT_NEAR(pe.torque(share * kEnd), kPe.torque(share * kEnd), 1e-4 * kPe.torque(kEnd)) << share;
        EXPECT_NEAR(se.torque(share * of_step), kSe.torque(share * of_step), 1e-4 * kSe.torque(kEnd)) << share;
    }
    for (const double share : {0.56, 0.75, 0.95}) {
        const double x = share * kEnd, y = compression * std::sqrt(kPe.energy(x)), y_step = compression * std::sqrt(kPe.energy(at * kEnd));
        EXPECT_NEAR(pe.torque(x) / kPe.torque(x), (1.0 + a) * (1.0 + a * (1.0 - y_step / y)), 2e-3) << share;
        const double wound = of_step + (kEnd - of_step) * (2.0 * share - 1.0);
        EXPECT_NEAR(se.torque(wound + a * (wound - of_step)) / kSe.torque(wound), 1.0 / (1.0 + a), 2e-3) << share;
    }
}

TEST(CamSpring, ArmsThatNoSpoolHasGiveAStiffSpringThatCanBeReadEverywhere) {
    const NominalCams cams(kStiffening);
    ASSERT_GT(cams.shortest_series_arm(), 0.005);
    for (const SpringBuild& build :
         {SpringBuild{.radius = -0.02}, {.radius = -0.5}, {.preload = -1.0, .stretch = 5.0}, {.radius = -cams.shortest_series_arm()}}) {
        const CamSpring se = cams.series(build);
        EXPECT_GT(se.end(), 0.0);
        for (const double x : {-1.0, 0.0, 1e-6, 0.5, 3.0, 100.0}) EXPECT_TRUE(std::isfinite(se.torque(x)) && se.torque(x) >= 0.0) << x;
        EXPECT_TRUE(std::isfinite(se.deflection(0.3)));
    }
}

TEST(CamSpring, AWoundSpringPullsAtDeflection0AndLetsGoWithinAShortWay) {
    const CamSpring wound = NominalCams(kStiffening).series({.preload = 0.3});
    EXPECT_GT(wound.torque(0.0), 0.05);
    EXPECT_NEAR(wound.torque(-0.005), 0.5 * wound.torque(0.0), 1e-12);
    EXPECT_EQ(wound.torque(-0.011), 0.0);
}

TEST(CamSpring, ACurveThatFallsOrStaysIsRefused) {
    for (const double torque : {0.0, -0.01}) {
        gap_case::NominalRig rig = straight_rig();
        rig.springs[10].pe_torque = rig.springs[9].pe_torque + torque;
        EXPECT_EQ(field_refused([&] { return NominalCams(rig); }), "springs");
    }
}

}  // namespace
}  // namespace fusee::joint_model
