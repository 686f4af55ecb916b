#include "fusee/design/algorithm_1.h"

#include <gtest/gtest.h>

#include <cmath>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/population.hpp>
#include <random>

#include "design/numeric_algorithm_1.h"
#include "fusee/actuator/dead_band.h"
#include "fusee/core/error.h"
#include "fusee/design/evolution.h"
#include "fusee/spring/laws.h"

namespace fusee::design {
namespace {

using X = std::array<double, 3>;

/// The rig of profiles/pnrvsa.toml and the travel of its law from 0.6 to 1 Nm.
constexpr Algorithm1Rig kRig{0.28, 1.0, {0.6, 1.0}, 2.21};
constexpr X kShipped{0.225, 0.0012, 0.265};

Algorithm1Options wanted() {
    Algorithm1Options options;
    options.wanted_travel = 1.0;
    options.weight_travel = 1.0;
    return options;
}

/// Seeded feasible designs: T at the start between 0.02 and 0.98, shared between u and C as it comes, C below 0 now and then.
std::vector<X> random_designs(const Algorithm1Rig& rig, int count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<X> designs;
    while (static_cast<int>(designs.size()) < count) {
        const double s = rig.torques.low, t = 0.02 + 0.96 * unit(random), share = 1.3 * unit(random);
        const double a = share * t * s * s, c = (1.0 - share) * t * s;
        if (a + c * rig.highest_load <= 1e-3 * rig.highest_load) continue;
        designs.push_back({std::pow(10.0, -1.5 + 2.0 * unit(random)), std::sqrt(a * rig.mu), c});
    }
    return designs;
}

TEST(Algorithm1, TermsAreThoseOfTheLawAndOfTheJoint) {
    const Algorithm1 algorithm(wanted(), kRig);
    for (const X& x : random_designs(kRig, 200)) {
        const Algorithm1Terms terms = algorithm.terms(x);
        ASSERT_TRUE(terms.feasible);
        const auto law = spring::make_stiction_law({x[0], x[1], x[2], kRig.mu, kRig.torques.low, kRig.highest_load});
        ASSERT_TRUE(law);
        actuator::Actuator joint;
        joint.law = *law;
        joint.capstan_radius = joint.joint_radius = 0.03;
        joint.gear_friction = spring::FrictionLaw::proportional(kRig.mu);
        const actuator::DeadBand first = actuator::dead_band(joint, 0.6), last = actuator::dead_band(joint, 1.0);
        EXPECT_NEAR(terms.travel, last.theta, 1e-12 * last.theta);
        EXPECT_NEAR(terms.initial_dead_band, std::min(first.linear, wanted().joint_range), 1e-10);
        EXPECT_NEAR(terms.final_dead_band, std::min(last.linear, wanted().joint_range), 1e-10);
        EXPECT_NEAR(terms.sensitivity * last.free_joint_stiffness, 1.0, 1e-12);
        EXPECT_NEAR(terms.cost, std::abs(terms.travel - 1.0) + terms.final_dead_band - terms.initial_dead_band + 0.1 * terms.sensitivity,
                    1e-12 * (1.0 + std::abs(terms.cost)));
        EXPECT_EQ(algorithm(x), terms.cost);
    }
}

TEST(Algorithm1, EqualsThePapersNumericWay) {
    for (const Algorithm1Rig& rig : {kRig, Algorithm1Rig{0.28, 1.6, {0.12, 1.0}, 1.0}, Algorithm1Rig{0.1, 0.7, {0.5, 1.5}, 1.7}}) {
        const Algorithm1 closed(wanted(), rig);
        const NumericAlgorithm1 numeric(closed);
        // Central differences over 1e-5 of the torque: truncation up to 1e-7 of a dead-band near T = 1, rounding about 1e-8.
        for (const X& x : random_designs(rig, 60)) {
            const double cost = closed(x);
            EXPECT_NEAR(numeric(x), cost, 1e-6 * (1.0 + std::abs(cost))) << x[0] << " " << x[1] << " " << x[2];
        }
        for (const X& x : {X{0.3, 0.5, 0.4}, X{0.3, 0.05, -0.2}, X{0.3, 0.0, 0.9 * rig.torques.low + 0.1}, X{-0.3, 0.01, 0.05}})
            EXPECT_NEAR(numeric(x), closed(x), 1e-12 * (1.0 + closed(x)));
    }
}

TEST(Algorithm1, TheNumericWayStoresTheLawsEnergy) {
    const Algorithm1 closed(wanted(), kRig);
    const NumericAlgorithm1 numeric(closed);
    const auto law = *spring::make_stiction_law({kShipped[0], kShipped[1], kShipped[2], kRig.mu, 0.6, 1.0});
    EXPECT_NEAR(numeric.measure(kShipped).stored_energy, law->at_load(1.0).u_se + law->at_load(1.0).u_pe, 1e-10);
}

TEST(Algorithm1, OnlyTheSquareOfUCounts) {
    const Algorithm1 algorithm(wanted(), kRig);
    for (const X& x : random_designs(kRig, 50)) EXPECT_EQ(algorithm(x), algorithm(X{x[0], -x[1], x[2]}));
}

TEST(Algorithm1, TheFirstStageLeadsTowardsSprings) {
    const Algorithm1 algorithm(wanted(), kRig);
    // C at 0.8 and above: T = 1 lies above 0.6 Nm; the further, the softer K_PE would have to be.
    double last = 0.0;
    for (const double c : {0.61, 0.7, 0.8, 0.9}) {
        const Algorithm1Terms terms = algorithm.terms(X{0.3, 0.0, c});
        EXPECT_FALSE(terms.feasible);
        EXPECT_LT(terms.least_stiffness, 0.0);
        EXPECT_EQ(terms.cost, -terms.least_stiffness);
        EXPECT_TRUE(std::isnan(terms.travel) && std::isnan(terms.final_dead_band) && std::isnan(terms.sensitivity));
        EXPECT_GT(terms.cost, last);
        last = terms.cost;
    }
    // By hand: k tau^2 (tau/C - 1) at 0.6 Nm.
    EXPECT_NEAR(algorithm(X{0.3, 0.0, 0.8}), 0.3 * 0.36 * 0.25, 1e-15);
    EXPECT_FALSE(algorithm.terms(X{0.3, 0.0, 0.0}).feasible) << "T = 0 asks for an infinitely stiff K_PE";
    EXPECT_FALSE(algorithm.terms(X{0.3, 0.0, 0.6}).feasible) << "T = 1 asks for no K_PE";
    EXPECT_FALSE(algorithm.terms(X{0.0, 0.0, 0.3}).feasible);
}

TEST(Algorithm1, TheSpringsMustExistUpToTheHighestLoad) {
    const X x{0.3, 0.15, -0.05};  // T reaches 0 at u^2/(mu |C|) = 1.607 Nm
    Algorithm1Rig rig = kRig;
    rig.highest_load = 1.0;
    EXPECT_TRUE(Algorithm1(wanted(), rig).terms(x).feasible);
    rig.highest_load = 1.60;
    EXPECT_TRUE(Algorithm1(wanted(), rig).terms(x).feasible);
    rig.highest_load = 1.61;
    EXPECT_FALSE(Algorithm1(wanted(), rig).terms(x).feasible);
}

/// As T(start) nears 1 the linear dead-band there, and with it the cost as the paper prints it, has no bound; the joint's range gives one.
TEST(Algorithm1, TheJointsRangeBoundsTheReward) {
    Algorithm1Options printed = wanted(), mended = wanted();
    printed.joint_range = 1e8;
    double last = 0.0;
    for (const double gap : {1e-2, 1e-4, 1e-6}) {
        const X x{0.3, 0.0, 0.6 * (1.0 - gap)};
        EXPECT_LT(Algorithm1(printed, kRig)(x), last - 10.0);
        EXPECT_GT(Algorithm1(mended, kRig)(x), -mended.joint_range);
        last = Algorithm1(printed, kRig)(x);
    }
}

/// W2 large enough: the optimum lies below 0, where the first stage never is.
TEST(Algorithm1, TheOptimumIsNegativeAndWhatTheSearchFinds) {
    Algorithm1Options options = wanted();
    const Algorithm1 algorithm(options, kRig);
    EvolutionOptions search;
    search.bounds = algorithm.bounds();
    search.generations = 150;
    const EvolutionResult found = evolve(algorithm, search);
    const Algorithm1Terms terms = algorithm.terms(found.best);
    EXPECT_TRUE(terms.feasible);
    EXPECT_LT(found.cost, -1.0);
    EXPECT_LT(found.cost, algorithm(kShipped));
    // No point of a grid over the box is better.
    for (int i = 0; i <= 40; ++i)
        for (int j = 0; j <= 40; ++j)
            for (int l = 0; l <= 40; ++l) {
                const auto at = [](const core::Range& r, int n) { return r.low + r.width() * n / 40.0; };
                EXPECT_GE(algorithm(X{at(options.k, i), at(options.u, j), at(options.c, l)}), found.cost - 1e-9);
            }
}

/// The cost as a pagmo problem.
struct PagmoProblem {
    [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& x) const { return {Algorithm1(wanted(), kRig)(x)}; }
    [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
        pagmo::vector_double low, high;
        for (const core::Range& box : Algorithm1(wanted(), kRig).bounds()) low.push_back(box.low), high.push_back(box.high);
        return {low, high};
    }
};

TEST(Algorithm1, PagmosSadeAndCmaesFindTheSameOptimum) {
    EvolutionOptions search;
    search.bounds = Algorithm1(wanted(), kRig).bounds();
    search.generations = 400;
    const EvolutionResult ours = evolve(Algorithm1(wanted(), kRig), search);
    // The optimum is a crease (the wanted travel) that ends at the edge of the box: all three are within 1e-5 of its floor.
    for (const pagmo::algorithm& theirs : {pagmo::algorithm(pagmo::sade(1000, 2, 1, 1e-14, 1e-14, false, 5)),
                                           pagmo::algorithm(pagmo::cmaes(1000, -1, -1, -1, -1, 0.5, 1e-14, 1e-14, false, true, 5))}) {
        const pagmo::population end = theirs.evolve(pagmo::population(pagmo::problem(PagmoProblem{}), 60, 5u));
        EXPECT_NEAR(end.champion_f()[0], ours.cost, 1e-5) << theirs.get_name();
    }
}

TEST(Algorithm1, ScansPassThroughTheOptimum) {
    const Algorithm1 algorithm(wanted(), kRig);
    const auto scans = scan_costs(algorithm, kShipped, 101);
    for (std::size_t j = 0; j < 3; ++j) {
        ASSERT_EQ(scans[j].value.size(), 101u);
        for (std::size_t i = 0; i < 101; ++i) {
            X x = kShipped;
            x[j] = scans[j].value[i];
            EXPECT_EQ(scans[j].cost[i], algorithm(x));
            EXPECT_EQ(scans[j].feasible[i], algorithm.terms(x).feasible);
        }
    }
    EXPECT_EQ(scans[1].value.front(), -0.3);
    EXPECT_EQ(scans[1].value.back(), 0.3);
    for (std::size_t i = 0; i < 50; ++i) EXPECT_NEAR(scans[1].cost[i], scans[1].cost[100 - i], 1e-12);
    EXPECT_THROW((void)scan_costs(algorithm, kShipped, 1), core::InvalidInput);
}

TEST(Algorithm1, WrongOptionsAreNamed) {
    using Spoil = void (*)(Algorithm1Options&, Algorithm1Rig&);
    const std::pair<std::string, Spoil> cases[] = {
        {"algorithm_1.k_per_Nm_rad", [](auto& o, auto&) { o.k.low = 0.0; }},
        {"algorithm_1.k_per_Nm_rad", [](auto& o, auto&) { o.k.high = 0.01; }},
        {"algorithm_1.u_Nm", [](auto& o, auto&) { o.u.high = std::nan(""); }},
        {"algorithm_1.c_Nm",
         [](auto& o, auto&) {
             o.c = {1.0, 0.5};
         }},
        {"algorithm_1.torques", [](auto& o, auto&) { o.torques = 1; }},
        {"algorithm_1.wanted_travel_deg", [](auto& o, auto&) { o.wanted_travel = 0.0; }},
        {"algorithm_1.joint_range_deg", [](auto& o, auto&) { o.joint_range = -1.0; }},
        {"algorithm_1.weight_travel_per_rad", [](auto& o, auto&) { o.weight_travel = -1.0; }},
        {"algorithm_1.weight_dead_band_per_rad", [](auto& o, auto&) { o.weight_dead_band = -1.0; }},
        {"algorithm_1.weight_sensitivity_Nm_per_rad", [](auto& o, auto&) { o.weight_sensitivity = -1.0; }},
        {"rig.gear_friction", [](auto&, auto& r) { r.mu = 0.0; }},
        {"rig.ratio", [](auto&, auto& r) { r.ratio = 0.0; }},
        {"torques.low", [](auto&, auto& r) { r.torques.low = 0.0; }},
        {"rig.peak_torque_Nm", [](auto&, auto& r) { r.torques.high = r.torques.low; }},
        {"highest_load", [](auto&, auto& r) { r.highest_load = 0.9; }},
    };
    for (const auto& [field, spoil] : cases) {
        Algorithm1Options options = wanted();
        Algorithm1Rig rig = kRig;
        spoil(options, rig);
        try {
            const Algorithm1 algorithm(options, rig);
            ADD_FAILURE() << field;
        } catch (const core::InvalidInput& e) {
            EXPECT_EQ(e.field(), field);
        }
    }
}

}  // namespace
}  // namespace fusee::design
