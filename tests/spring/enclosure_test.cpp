#include "fusee/spring/enclosure.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "fusee/spring/law.h"
#include "fusee/spring/laws.h"

namespace fusee::spring {
namespace {

using math::Interval;
using math::Jet;

struct NamedLaw {
    const char* name;
    SpringLawPtr law;
};

SpringLawPtr table_law() {
    std::vector<double> x, f;
    for (int i = 0; i <= 40; ++i) x.push_back(0.05 * i), f.push_back(0.1 + 0.2 * x.back() + 0.05 * std::pow(x.back(), 3));
    return make_pair_law(make_tabulated(x, f, {.knots = 6}), make_exponential(0.2, 0.8, 0.05), 0.2, 1.2).value();
}

SpringLawPtr dead_band_law(const spring::FrictionLaw& friction) {
    return make_dead_band_law({.dead_band = math::make_formula("dead_band", "0.838*tau^-2.2", "tau", {0.6, 2.0}),
                               .friction = friction,
                               .start_torque = 0.6,
                               .end_torque = 2.0})
        .value();
}

/// Every maker of laws.
std::vector<NamedLaw> cases() {
    const StictionLawOptions paper{0.225, 0.0012, 0.265, 0.28, 0.6, 2.09};
    const auto table = spring::FrictionLaw::tabulated({0.2, 0.8, 1.3, 2.2}, {0.06, 0.22, 0.37, 0.6}, 0.02);
    const std::vector<double> loads{0.6, 0.9, 1.2, 1.5, 2.0}, stiffness{0.08, 0.18, 0.33, 0.5, 0.9}, share{0.44, 0.3, 0.22, 0.18, 0.13};
    return {{"(k, u, C)", make_stiction_law(paper).value()},
            {"lead-in", with_lead_in(make_stiction_law(paper).value(), 0.05).value()},
            {"polynomials", make_pair_law(make_polynomial({0.02, 0.01, 0.003}), make_polynomial({0.05, 0.02, 0.006}), 0.1, 1.5).value()},
            {"table and exponential", with_lead_in(table_law(), 0.02).value()},
            {"dead-band", dead_band_law(spring::FrictionLaw::proportional(0.28))},
            {"dead-band, friction table", dead_band_law(table)},
            {"(k, u, C), friction table", make_general_stiction_law({0.225, 0.0012, 0.265, table, 0.6, 2.0}).value()},
            {"S and T as tables",
             make_transmission_law(math::make_interpolant(loads, stiffness), math::make_interpolant(loads, share), 0.6, 2.0).value()},
            {"knots", make_free_curve({loads, stiffness, share}).value()}};
}

struct Figure {
    const char* name;
    double LawPoint::*point;
    Jet LawJet::*box;
};
const std::array kFigures{
    Figure{"tau", &LawPoint::tau, &LawJet::tau},
    Figure{"theta", &LawPoint::theta, &LawJet::theta},
    Figure{"f_se", &LawPoint::f_se, &LawJet::f_se},
    Figure{"f_pe", &LawPoint::f_pe, &LawJet::f_pe},
    Figure{"s", &LawPoint::s, &LawJet::s},
    Figure{"p", &LawPoint::p, &LawJet::p},
    Figure{"S'", &LawPoint::s_slope, &LawJet::s_slope},
    Figure{"P'", &LawPoint::p_slope, &LawJet::p_slope},
    Figure{"u_se", &LawPoint::u_se, &LawJet::u_se},
    Figure{"u_pe", &LawPoint::u_pe, &LawJet::u_pe},
};

TEST(EnclosedLaw, BoundsItsPoints) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (const auto& [name, law] : cases()) {
        SCOPED_TRACE(name);
        const std::vector<LawSegment> all = segments(*law);
        ASSERT_FALSE(all.empty());
        EXPECT_NEAR(math::middle(all.front().over(Interval(all.front().parameter.low)).tau.value), law->loads().low, 1e-12);
        EXPECT_NEAR(math::middle(all.back().over(Interval(all.back().parameter.high)).tau.value), law->loads().high, 1e-12);
        for (const LawSegment& s : all)
            for (int i = 0; i < 20; ++i) {
                const double q = std::lerp(s.parameter.low, s.parameter.high, share(random)), reach = std::pow(10.0, -5.0 * share(random));
                const LawJet here = s.over(Interval(q));
                const LawJet wide = s.over({std::lerp(q, s.parameter.low, reach), std::lerp(q, s.parameter.high, reach)});
                const LawPoint point = law->at_load(math::middle(here.tau.value));
                for (const Figure& f : kFigures) {
                    const Jet& at = here.*f.box;
                    // A point is found from its load, the box from its own parameter: they differ by what solving leaves.
                    EXPECT_NEAR(math::middle(at.value), point.*f.point, 1e-9 * std::abs(point.*f.point) + 1e-12) << f.name << " at " << q;
                    EXPECT_LT(boost::numeric::width(at.value), 1e-8 * (1.0 + std::abs(point.*f.point))) << f.name;
                    EXPECT_TRUE(boost::numeric::subset(at.value, (wide.*f.box).value)) << f.name << " at " << q;
                    EXPECT_TRUE(boost::numeric::subset(at.slope, (wide.*f.box).slope)) << f.name << " at " << q;
                }
            }
    }
}

// The slopes are those of the formulas: dU = F dtheta, dF = S dtheta, dS = S' dtheta.
TEST(EnclosedLaw, HasSlopesThatBelongTogether) {
    for (const auto& [name, law] : cases()) {
        SCOPED_TRACE(name);
        for (const LawSegment& s : segments(*law)) {
            const LawJet at = s.over(Interval(0.5 * (s.parameter.low + s.parameter.high)));
            const double turn = math::middle(at.theta.slope);
            const auto expect = [&](const Jet& figure, const Jet& derivative) {
                const double slope = math::middle(figure.slope), wanted = math::middle(derivative.value) * turn;
                EXPECT_NEAR(slope, wanted, 1e-8 * std::abs(wanted) + 1e-12);
            };
            expect(at.u_se, at.f_se);
            expect(at.u_pe, at.f_pe);
            expect(at.f_se, at.s);
            expect(at.f_pe, at.p);
            expect(at.s, at.s_slope);
            expect(at.p, at.p_slope);
        }
    }
}

}  // namespace
}  // namespace fusee::spring
