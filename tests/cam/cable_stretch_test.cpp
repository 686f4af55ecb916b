#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fixture.h"
#include "fusee/cam/arm.h"
#include "fusee/core/error.h"

// Elastic cables behind both cams (docs/theory/cams.md, eq. 18 to 22).
namespace fusee::cam {
namespace {

using namespace test;

constexpr double kCableCompliance = 2e-5;  // [m/N] half a metre of E A = 25 kN

// Known: a round cam of radius r that pulls a spring k, preloaded by y0, through a cable of compliance g has the torque
// r (k y0 + k_e r theta), k_e = k/(1 + k g): for that law the cam must be round again, and 1/(1 + k g) of the drawn cable reaches the
// spring.
TEST(Stretch, ARoundCamPullsItsSpringThroughItsCable) {
    const double r = 0.012, k = 8000.0, y0 = 0.004, both = k / (1.0 + k * kCableCompliance);
    const auto law = spring::make_pair_law(spring::make_polynomial({0.2, 0.1}), spring::make_polynomial({r * k * y0, both * r * r}),
                                           0.2 + r * k * y0, 2.0)
                         .value();
    const ArmFunction cam(PartKind::kParallel, law, compression(k, y0), kCapstan, {.cable_compliance = kCableCompliance});
    for (const double tau : {law->loads().low, 1.0, 2.0}) {
        const ArmPoint p = cam.at_load(tau);
        EXPECT_NEAR(p.arm, r, 1e-14);  // rounding, as in what follows
        EXPECT_NEAR(p.slope, 0.0, 1e-12);
        EXPECT_NEAR(p.second_derivative, 0.0, 1e-11);
        EXPECT_NEAR(p.tension, k * y0 + both * r * p.angle, 1e-10);
        EXPECT_NEAR(p.state, p.tension / k, 1e-15);
        EXPECT_NEAR(p.elongation.length, kCableCompliance * (p.tension - k * y0), 1e-15);
        EXPECT_NEAR(p.elongation.turn * r, p.elongation.length, 1e-15);
        EXPECT_EQ(p.elongation.travel, p.angle);
    }
}

// Known: a round spool of radius r on a torsion spring pulls its cable x as k_t/r^2; with the cable's compliance the capstan has
// F_0 + S theta, S = r_c^2/(r^2/k_t + g). Of the capstan's travel g S/r_c^2 goes into the cable.
TEST(Stretch, ARoundSpoolTurnsItsSpringThroughItsCable) {
    const double r = 0.02, kt = 0.02, phi0 = 3.0, s = kCapstan * kCapstan / (r * r / kt + kCableCompliance),
                 start = kt * phi0 / r * kCapstan;
    const auto law =
        spring::make_pair_law(spring::make_polynomial({start, s}), spring::make_polynomial({0.1, 0.2}), start + 0.1, 1.0).value();
    const ArmFunction spool(PartKind::kSeries, law, torsion(kt, phi0), kCapstan, {.cable_compliance = kCableCompliance});
    for (const double tau : {law->loads().low, 0.5, 1.0}) {
        const ArmPoint p = spool.at_load(tau);
        EXPECT_NEAR(p.arm, r, 1e-14);
        EXPECT_NEAR(p.slope, 0.0, 1e-12);
        EXPECT_NEAR(p.elongation.length, kCableCompliance * (p.tension - start / kCapstan), 1e-15);
        EXPECT_NEAR(p.elongation.turn, p.elongation.travel * kCableCompliance * s / (kCapstan * kCapstan), 1e-14);
        EXPECT_NEAR(kCapstan * p.elongation.travel, r * p.angle + p.elongation.length, 1e-14);  // the moved cable
    }
}

class OfBothCams : public ::testing::TestWithParam<PartKind> {
protected:
    [[nodiscard]] ArmFunction arm(const Allowance& allowance) const { return {GetParam(), stiction_law(), base(), kCapstan, allowance}; }
    [[nodiscard]] spring::BaseSpring base() const { return GetParam() == PartKind::kSeries ? torsion() : compression(); }
    [[nodiscard]] static double torque(PartKind kind, const spring::LawPoint& p) { return kind == PartKind::kSeries ? p.f_se : p.f_pe; }
    [[nodiscard]] std::vector<FoundArm> rows(const Allowance& allowance) const {
        const ArmFunction cam = arm(allowance);
        const core::Range loads = cam.law().loads();
        std::vector<FoundArm> found;
        for (int i = 0; i <= 2000; ++i) {
            const ArmPoint p = cam.at_load(loads.low + loads.width() * i / 2000);
            found.push_back({p.angle, p.arm});
        }
        return found;
    }
};
INSTANTIATE_TEST_SUITE_P(Stretch, OfBothCams, ::testing::Values(PartKind::kSeries, PartKind::kParallel),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

// Law: slope and second derivative are derivatives by the cam's own angle. Central differences over a load step h err by O(h^2).
TEST_P(OfBothCams, SlopesAreDerivatives) {
    const ArmFunction cam = arm({.cable_compliance = kCableCompliance});
    expect_derivatives(cam, {0.7, 1.4, 1.9});
}

// Law, by Hooke and torque over tension alone, without an energy: the arms, a linear spring and a cable that is longer by L F/(E A) have
// the torques of the law. Trapezoids over 2000 rows: 1e-6.
TEST_P(OfBothCams, SpringCamAndCableTogetherHaveTheLaw) {
    const std::vector<FoundArm> found = rows({.cable_compliance = kCableCompliance});
    const auto law = stiction_law();
    const spring::BaseSpring spring = base();
    const bool series = GetParam() == PartKind::kSeries;
    double moved = 0.0, first = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i > 0) moved += 0.5 * (found[i - 1].arm + found[i].arm) * (found[i].angle - found[i - 1].angle);
        if (series) {
            const double tension = spring.rate * (spring.preload + found[i].angle) / found[i].arm;
            if (i == 0) first = tension;
            const double theta = (moved + kCableCompliance * (tension - first)) / kCapstan, wanted = law->at_angle(theta).f_se;
            EXPECT_NEAR(kCapstan * tension, wanted, 1e-6 * wanted) << i;
        } else {  // Hooke twice: moved = (F - F_0)/k + g (F - F_0)
            const double tension = spring.rate * spring.preload + moved / (1.0 / spring.rate + kCableCompliance);
            const double wanted = law->at_angle(found[i].angle).f_pe;
            EXPECT_NEAR(tension * found[i].arm, wanted, 1e-6 * wanted) << i;
        }
    }
}

// Roundtrip, with every other allowance at once: the exported cam has the law. With a rigid cable the same cam has errors.
TEST_P(OfBothCams, ReadBackWithItsCableCarriesTheLaw) {
    const Allowance allowance{.radius = 2e-4, .series_compliance = 0.01, .cable_axis = 5e-5, .cable_compliance = kCableCompliance};
    const auto law = stiction_law();
    const auto as_cut = spring_of_arms(GetParam(), rows(allowance), base(), kCapstan, allowance);
    Allowance rigid = allowance;
    rigid.series_compliance = rigid.cable_compliance = 0.0;
    const auto judged_rigid = spring_of_arms(GetParam(), rows(allowance), base(), kCapstan, rigid);
    const double end = judged_rigid->domain().high;
    for (const double share : {0.0, 0.2, 0.6, 1.0}) {
        const double wanted = torque(GetParam(), law->at_angle(share * end));
        EXPECT_NEAR(as_cut->force(share * end), wanted, 1e-9 * wanted) << share;
    }
    const double wanted = torque(GetParam(), law->at_angle(end));
    EXPECT_GT(std::abs(judged_rigid->force(end) / wanted - 1.0), 0.01);
}

// Without data of the cable it is rigid, to the bit; the elongation is 0.
TEST_P(OfBothCams, WithoutComplianceNothingChanges) {
    const ArmPoint p = arm({}).at_load(1.3);
    EXPECT_EQ(p.elongation.length, 0.0);
    EXPECT_EQ(p.elongation.turn, 0.0);
    EXPECT_EQ(spring::in_series_with_cable(base(), 0.0).rate, base().rate);
    EXPECT_EQ(spring::in_series_with_cable(base(), 0.0).preload, base().preload);
    EXPECT_EQ(p.state,
              base().state(GetParam() == PartKind::kSeries ? stiction_law()->at_load(1.3).u_se : stiction_law()->at_load(1.3).u_pe));
}

// c = L/(E A r_c^2): a diagnosed compliance is added.
TEST(Stretch, BehindTheSpoolComplianceAddsUp) {
    const ArmFunction length(PartKind::kSeries, stiction_law(), torsion(), kCapstan, {.cable_compliance = kCableCompliance});
    const ArmFunction angle(PartKind::kSeries, stiction_law(), torsion(), kCapstan,
                            {.series_compliance = kCableCompliance / (kCapstan * kCapstan)});
    const ArmFunction halves(
        PartKind::kSeries, stiction_law(), torsion(), kCapstan,
        {.series_compliance = 0.5 * kCableCompliance / (kCapstan * kCapstan), .cable_compliance = 0.5 * kCableCompliance});
    for (const double tau : {0.7, 1.4, 2.0}) {
        EXPECT_DOUBLE_EQ(length.at_load(tau).arm, angle.at_load(tau).arm);
        EXPECT_NEAR(halves.at_load(tau).arm, angle.at_load(tau).arm, 1e-15);
    }
}

// No spool compensates for a cable softer than the law; a cam can for K_PE's.
TEST(Stretch, RefusesACableSofterThanTheSeriesSpring) {
    const double soft = kCapstan * kCapstan / stiction_law()->at_load(2.09).s;  // c S = 1 at the stiffest place
    const auto field = [](double give) -> std::string {
        try {
            (void)ArmFunction(PartKind::kSeries, stiction_law(), torsion(), kCapstan, {.cable_compliance = give});
        } catch (const core::InvalidInput& error) {
            return error.field();
        }
        return "";
    };
    EXPECT_EQ(field(0.99 * soft), "");
    EXPECT_EQ(field(1.01 * soft), "k_se.cable_length_mm");
    EXPECT_EQ(field(-1e-6), "k_se.cable_compliance");
    EXPECT_NO_THROW(ArmFunction(PartKind::kParallel, stiction_law(), compression(), kCapstan, {.cable_compliance = 1.01 * soft}));
}

}  // namespace
}  // namespace fusee::cam
