#include <gtest/gtest.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/spring/law.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"
#include "refused.h"

namespace fusee::spring {
namespace {

constexpr double kCapstan = 0.03;  // [m]
const BaseSpring kTorsion{.kind = BaseKind::kTorsion, .rate = 0.0183, .preload = 4.0};
const BaseSpring kCompression{.kind = BaseKind::kCompression, .rate = 7460.0, .preload = 0.0148};

SpringLawPtr law_with_lead_in(double lead_in = 0.0) {
    const auto law = make_stiction_law({.k = 0.225, .u = 0.0012, .c = 0.265, .mu = 0.28, .start_torque = 0.6, .end_torque = 2.1});
    return *with_lead_in(*law, lead_in);
}

struct NominalSpring {
    PotentialPtr nominal;
    BaseSpring base;
};
std::vector<NominalSpring> both(double lead_in = 0.0) {
    const SpringLawPtr law = law_with_lead_in(lead_in);
    return {{series_spring(law), kTorsion}, {parallel_spring(law), kCompression}};
}

/// A spool of constant radius R on a torsion spring: F = r_c k (c + phi0)/R over x = R c/r_c, a straight line.
PotentialPtr constant_spool(double radius) {
    const double g = kCapstan / radius;
    return make_polynomial({g * kTorsion.rate * kTorsion.preload, g * g * kTorsion.rate});
}
/// A cam of constant radius R on a compression spring: F = k R (R x + y0).
PotentialPtr constant_cam(double radius) {
    return make_polynomial({kCompression.rate * radius * kCompression.preload, kCompression.rate * radius * radius});
}

TEST(BuiltSpring, WithoutErrorIsTheNominalSpring) {
    for (const auto& [nominal, base] : both(0.8)) {
        const PotentialPtr built = make_built_spring(nominal, base, kCapstan, {});
        EXPECT_EQ(built->domain().low, nominal->domain().low);
        EXPECT_EQ(built->domain().high, nominal->domain().high);
        const double top = nominal->domain().high;
        for (int i = 0; i <= 50; ++i) {
            const double x = top * i / 50.0;
            EXPECT_NEAR(built->energy(x), nominal->energy(x), 1e-12 * nominal->energy(top));
            EXPECT_NEAR(built->force(x), nominal->force(x), 1e-12 * nominal->force(x));
            EXPECT_NEAR(built->stiffness(x), nominal->stiffness(x), 1e-12 * nominal->stiffness(top));
            EXPECT_NEAR(built->slope(x), nominal->slope(x), 1e-12 * nominal->slope(top));
        }
    }
}

TEST(BuiltSpring, ARateErrorScalesTheForce) {
    for (const auto& [nominal, base] : both()) {
        const PotentialPtr built = make_built_spring(nominal, base, kCapstan, {.rate = 0.07});
        EXPECT_EQ(built->domain().high, nominal->domain().high);
        for (int i = 0; i <= 20; ++i) {
            const double x = nominal->domain().high * i / 20.0;
            EXPECT_NEAR(built->force(x), 1.07 * nominal->force(x), 1e-13);
            EXPECT_NEAR(built->stiffness(x), 1.07 * nominal->stiffness(x), 1e-12 * nominal->stiffness(x));
        }
    }
}

TEST(BuiltSpring, AWiderSpoolIsKnownByHand) {
    const double radius = 0.02, wider = 0.0015;
    const PotentialPtr built = make_built_spring(constant_spool(radius), kTorsion, kCapstan, {.radius = wider});
    const PotentialPtr expected = constant_spool(radius + wider);
    EXPECT_NEAR(built->domain().high, kLongestDeflection * (radius + wider) / radius, 1e-10);  // the same arc pays out more cable
    for (const double x : {0.0, 0.3, 2.0, 40.0}) {
        EXPECT_NEAR(built->force(x), expected->force(x), 1e-13 * expected->force(x));
        EXPECT_NEAR(built->stiffness(x), expected->stiffness(x), 1e-12 * expected->stiffness(x));
        EXPECT_NEAR(built->energy(x), expected->energy(x), 1e-12 * expected->energy(x));
        EXPECT_NEAR(built->slope(x), 0.0, 1e-13);
    }
    const PotentialPtr narrower = make_built_spring(constant_spool(radius), kTorsion, kCapstan, {.radius = -wider});
    EXPECT_LT(narrower->domain().high, kLongestDeflection);
}

TEST(BuiltSpring, AWiderCamIsKnownByHand) {
    const double radius = 0.012;
    const PotentialPtr built = make_built_spring(constant_cam(radius), kCompression, kCapstan, {.radius = -0.0004});
    const PotentialPtr expected = constant_cam(radius - 0.0004);
    EXPECT_EQ(built->domain().high, kLongestDeflection);
    for (const double x : {0.0, 0.3, 2.0, 40.0}) {
        EXPECT_NEAR(built->force(x), expected->force(x), 1e-12 * expected->force(x));
        EXPECT_NEAR(built->stiffness(x), expected->stiffness(x), 1e-11 * expected->stiffness(x));
    }
}

TEST(BuiltSpring, APreloadErrorAddsAConstantAtTheArm) {
    const double more = 0.2;
    const PotentialPtr built = make_built_spring(constant_spool(0.02), kTorsion, kCapstan, {.preload = more});
    for (const double x : {0.0, 0.5, 3.0})
        EXPECT_NEAR(built->force(x), constant_spool(0.02)->force(x) + kCapstan / 0.02 * kTorsion.rate * more, 1e-14);
    // K_PE of the paper's law: dF = k dy0 r, with the nominal arm r = F/(k (y + y0)).
    const auto [nominal, base] = both()[1];
    const PotentialPtr trimmed = make_built_spring(nominal, base, kCapstan, {.preload = 0.001});
    for (int i = 0; i <= 10; ++i) {
        const double x = nominal->domain().high * i / 10.0, arm = nominal->force(x) / base.load(nominal->energy(x));
        EXPECT_NEAR(trimmed->force(x), nominal->force(x) + base.rate * 0.001 * arm, 1e-13);
    }
}

/// All errors at once: force, stiffness and slope are the derivatives of the energy, and the spool's and cam's own integrals hold.
TEST(BuiltSpring, IsConsistentWithAllErrorsAtOnce) {
    const BuildError errors[] = {{.rate = -0.08, .radius = 0.0006, .preload = 0.0}, {.rate = 0.1, .radius = -0.0004, .preload = 0.0}};
    for (const auto& [nominal, base] : both())
        for (BuildError error : errors) {
            error.preload = 0.05 * base.preload;
            const PotentialPtr built = make_built_spring(nominal, base, kCapstan, error);
            const core::Range domain = built->domain();
            const double h = 1e-5 * domain.width();
            EXPECT_NEAR(built->energy(domain.low), 0.0, 1e-15);
            for (int i = 1; i < 30; ++i) {  // h^2/6 of derivatives that grow about tenfold each
                const double x = domain.low + domain.width() * i / 30.0;
                EXPECT_NEAR((built->energy(x + h) - built->energy(x - h)) / (2.0 * h), built->force(x), 1e-8 * built->force(x));
                EXPECT_NEAR((built->force(x + h) - built->force(x - h)) / (2.0 * h), built->stiffness(x), 1e-7 * built->stiffness(x));
                EXPECT_NEAR((built->stiffness(x + h) - built->stiffness(x - h)) / (2.0 * h), built->slope(x), 1e-6 * built->slope(x));
            }
        }
}

/// An independent way to the same spring: walk along the nominal cam in small steps and sum cable and state.
TEST(BuiltSpring, AgreesWithAWalkAlongTheCam) {
    const BuildError error{.rate = 0.06, .radius = 0.0005, .preload = 0.0};
    for (const NominalSpring& each : both()) {
        const PotentialPtr& nominal = each.nominal;
        const BaseSpring& base = each.base;
        const PotentialPtr built = make_built_spring(nominal, base, kCapstan, error);
        const bool spool = base.kind == BaseKind::kTorsion;
        constexpr int kSteps = 4000;
        const double top = nominal->domain().high, dx = top / kSteps;
        const auto arm = [&](double x) {
            const double load = base.load(nominal->energy(x));
            return spool ? kCapstan * load / nominal->force(x) : nominal->force(x) / load;
        };
        double built_x = 0.0, state = base.preload;
        for (int i = 0; i < kSteps; ++i) {  // midpoint rule
            const double r = arm((i + 0.5) * dx);
            built_x += spool ? dx * (r + error.radius) / r : dx;
            state += spool ? dx * kCapstan / r : dx * (r + error.radius);
            if (i % 400 != 399) continue;
            const double end = arm((i + 1) * dx) + error.radius, rate = base.rate * 1.06;
            const double force = spool ? kCapstan * rate * state / end : rate * state * end;
            EXPECT_NEAR(built->force(std::min(built_x, built->domain().high)), force, 1e-6 * force);  // (1/4000)^2 times the curvature
        }
        EXPECT_NEAR(built_x, built->domain().high, 1e-6);
    }
}

TEST(BuiltSpringRefusal, ImpossibleErrorsAreNamed) {
    const auto field = [](const BuildError& error) {
        return field_refused([&] { return make_built_spring(constant_cam(0.012), kCompression, kCapstan, error); });
    };
    EXPECT_EQ(field({.radius = -0.0119}), "accepted");
    EXPECT_EQ(field({.radius = -0.0121}), "build_error.radius");
    EXPECT_EQ(field({.rate = -1.0}), "build_error.rate + 1");
    EXPECT_EQ(field({.preload = -0.02}), "spring.preload + build_error.preload");
    EXPECT_THROW((void)make_built_spring(constant_cam(0.012), kCompression, 0.0, {}), core::InvalidInput);
}

TEST(Resampled, IsTheSameSpring) {
    for (const double lead_in : {0.0, 0.8})
        for (const auto& [nominal, base] : both(lead_in)) {
            const PotentialPtr fast = resampled(nominal);
            ASSERT_NE(fast, nominal) << lead_in;
            const double top = nominal->domain().high;
            for (int i = 0; i <= 300; ++i) {
                const double x = top * i / 300.0;
                EXPECT_NEAR(fast->energy(x), nominal->energy(x), 1e-12 * nominal->energy(top));
                EXPECT_NEAR(fast->force(x), nominal->force(x), 1e-12 * nominal->force(top));
                EXPECT_NEAR(fast->stiffness(x), nominal->stiffness(x), 1e-9 * nominal->stiffness(top));
                EXPECT_NEAR(fast->slope(x), nominal->slope(x), 1e-6 * nominal->slope(top));
            }
        }
}

/// C < 0 ends close below the load at which T is 0: dtau/dtheta = S/T = 540 Nm/rad, so that 1e-16 of the angle is 1e-13 of the load.
TEST(Resampled, FollowsALawUpToItsAsymptote) {
    const PotentialPtr nominal =
        series_spring(*make_stiction_law({.k = 0.42, .u = 0.2, .c = -0.1, .mu = 0.28, .start_torque = 0.5, .end_torque = 1.4}));
    const PotentialPtr fast = resampled(nominal);
    ASSERT_NE(fast, nominal);
    const double top = nominal->domain().high;
    for (int i = 0; i <= 300; ++i) EXPECT_NEAR(fast->force(top * i / 300.0), nominal->force(top * i / 300.0), 1e-9 * nominal->force(top));
}

TEST(Resampled, ASpringWithAKinkStaysAsItIs) {
    class Kinked final : public Potential {
    public:
        [[nodiscard]] core::Range domain() const override { return {0.0, 2.0}; }
        [[nodiscard]] double energy(double x) const override { return 0.5 * x * x; }
        [[nodiscard]] double force(double x) const override { return x < 1.1 ? x : 1.1 + 3.0 * (x - 1.1); }
        [[nodiscard]] double stiffness(double x) const override { return x < 1.1 ? 1.0 : 3.0; }
        [[nodiscard]] double slope(double) const override { return 0.0; }
    };
    const PotentialPtr kinked = std::make_shared<Kinked>();
    EXPECT_EQ(resampled(kinked), kinked);
}

}  // namespace
}  // namespace fusee::spring
