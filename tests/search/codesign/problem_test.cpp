#include "codesign/problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fusee/actuator/dead_band.h"
#include "fusee/core/error.h"
#include "fusee/pipeline/design.h"
#include "pipeline/fixture.h"

namespace fusee::search::codesign {
namespace {

class CoDesignProblem : public fixtures::TempFolder {
protected:
    /// The shipped profile, with what a lab's search was held to: 1.5 rad of travel from 0.6 to 2.1 Nm.
    [[nodiscard]] profile::Profile read(const std::map<std::string, std::string>& keys = {}) const {
        std::string text = core::read_file(fixtures::shipped("pnrvsa"));
        for (const auto& [key, value] : {std::pair<std::string, std::string>{"co_design.loads_Nm", "[0.6, 2.1]"},
                                         {"co_design.torques_Nm", "[1.0, 1.5]"},
                                         {"co_design.capstan_radius_mm", "[25.0, 40.0]"}})
            text = fixtures::with_key(text, key, value);
        for (const auto& [key, value] : keys) text = fixtures::with_key(text, key, value);
        return profile::read_profile(write("p/pnrvsa.toml", text));
    }
    static void expect_refused(const profile::Profile& profile, const std::string& field) {
        try {
            const Problem problem(profile);
            ADD_FAILURE() << field;
        } catch (const core::InvalidInput& e) {
            EXPECT_EQ(e.field(), field);
        }
    }
    [[nodiscard]] static std::vector<double> draw(const Problem& problem, std::mt19937_64& random) {
        std::uniform_real_distribution<double> share(0.0, 1.0);
        std::vector<double> x;
        for (const core::Range& box : problem.bounds()) x.push_back(box.low + share(random) * box.width());
        return x;
    }
    /// A design that was found for cables that leave parallel, as its head says, with the guides of that search.
    [[nodiscard]] static profile::Profile as_searched(const char* name) {
        profile::Profile profile = profile::read_profile(fixtures::shipped(name));
        for (profile::PartSpec* part : {&profile.k_se, &profile.k_pe}) {
            part->cam.guide.kind = cam::GuideKind::kParallel;
            part->cam.guide.distance = 10.0;
        }
        profile.limits.push_back({"cam.parallel_exit", "review_percent", 1.0, "the search knew no such rule"});
        return profile;
    }
    [[nodiscard]] static const Limit* find(const Trial& trial, const std::string& name) {
        for (const Limit& limit : trial.limits)
            if (limit.name == name) return &limit;
        return nullptr;
    }
};

/// One trial that accepts reviews tells what a second one that avoids them, with larger radii, would.
TEST_F(CoDesignProblem, ATrialTellsWhatAvoidingItsReviewsFinds) {
    profile::Profile base = read({{"co_design.reviews", "\"accept\""}});
    base.co_design.least_rho_se = base.co_design.least_rho_pe = 1e-3;
    const Problem accepting(base);
    const Trial trial = accepting.evaluate(base);
    std::string broken_limits;
    for (const core::Finding& f : broken(trial)) broken_limits += core::to_line(f) + "\n";
    ASSERT_TRUE(trial.feasible()) << broken_limits;
    for (const double rho : {1.5e-3, 2.5e-3, 9e-3}) {
        profile::Profile stricter = base;
        stricter.co_design.reviews = design::Reviews::kAvoid;
        stricter.co_design.least_rho_se = stricter.co_design.least_rho_pe = rho;
        const Trial strict = Problem(stricter).evaluate(base), told = avoiding_reviews(trial, rho);
        EXPECT_DOUBLE_EQ(told.violation, strict.violation) << rho;
        EXPECT_EQ(told.radius, strict.radius) << rho;
        EXPECT_EQ(told.figure, strict.figure) << rho;
    }
}

TEST_F(CoDesignProblem, DemandsLeftOutAreThoseOfTheProfilesOwnLaw) {
    const Problem problem(read());
    // (k, u, C) = (0.225, 0.0012, 0.265): docs/theory/springs.md, eq. 5; stiffness 2 k tau^2 at r_j = r_c
    const double a = 0.0012 * 0.0012 / 0.28;
    const double travel = (a * (std::pow(0.6, -3) - std::pow(2.1, -3)) / 3 + 0.265 * (std::pow(0.6, -2) - std::pow(2.1, -2)) / 2) / 0.225;
    EXPECT_NEAR(problem.options().travel, travel, 1e-9);
    EXPECT_NEAR(problem.options().soft, 2 * 0.225 * 0.36, 1e-9);
    EXPECT_NEAR(problem.options().stiff, 2 * 0.225 * 4.41, 1e-9);
}

TEST_F(CoDesignProblem, TheProfilesOwnDesignIsJudgedByWhatTheSearchIsHeldTo) {
    const profile::Profile own = read();
    const Problem problem(own);
    const Trial trial = problem.evaluate(own);
    // It covers every edge, meets its own demands and stays within 40 mm, but its K_PE is more sharply curved (2.85 mm).
    EXPECT_FALSE(trial.feasible());
    const Limit *rho = find(trial, "limit.rho k_pe"), *radius = find(trial, "limit.contour_radius k_pe");
    ASSERT_TRUE(rho && radius);
    EXPECT_NEAR(rho->measured, 2.852, 1e-3);
    EXPECT_GT(rho->excess(), 0.0);
    EXPECT_LT(radius->excess(), 0.0);
    double excess = 0.0;
    for (const Limit& limit : trial.limits) excess += std::max(0.0, limit.excess());
    EXPECT_NEAR(trial.violation, excess + 20.0, 1e-9) << "cams and rules, which are not asked any more, count besides";
    EXPECT_NEAR(trial.dead_band[0], actuator::dead_band(pipeline::resolve(own)->actuator, 1.0).exact_width, 1e-9);
}

TEST_F(CoDesignProblem, TheDesignThatWasFoundKeepsEveryLimitAndTheIssuesFigures) {
    const profile::Profile found = as_searched("pnrvsa_co_design");
    const Problem problem(found);
    const Trial trial = problem.evaluate(found);
    for (const Limit& limit : trial.limits) EXPECT_LE(limit.excess(), 0.0) << limit.name;
    EXPECT_TRUE(trial.feasible());
    // A lab's search reached 51 deg at 1 Nm and 19.5 deg at 1.5 Nm with 1.5 rad of travel from 0.6 to 2.1 Nm.
    EXPECT_LE(core::deg_from_rad(trial.dead_band[0]), 51.0);
    EXPECT_LE(core::deg_from_rad(trial.dead_band[1]), 19.5);
    EXPECT_GE(trial.travel, 1.5);
    EXPECT_EQ(problem.options().loads.low, 0.6);
    EXPECT_EQ(problem.options().loads.high, 2.1);
}

// A search found such cams, and only the make of the best one refused them.
TEST_F(CoDesignProblem, ACableShorterThanItsWrapBreaksALimit) {
    profile::Profile found = as_searched("pnrvsa_co_design");
    found.k_pe.cable_length = 0.04;
    const Trial trial = Problem(found).evaluate(found);
    const Limit* cable = find(trial, "cable.length k_pe");
    ASSERT_NE(cable, nullptr);
    EXPECT_GT(cable->excess(), 0.0);
    EXPECT_FALSE(trial.feasible());
}

TEST_F(CoDesignProblem, AFreeCurveIsClearlyBetterAtTheSameTravelAndStiffness) {
    const profile::Profile found = as_searched("pnrvsa_co_design");
    const profile::Profile free = as_searched("free_curve");
    profile::Profile same = free;
    same.co_design = found.co_design;
    const Trial trial = Problem(same).evaluate(free), other = Problem(found).evaluate(found);
    EXPECT_TRUE(trial.feasible()) << "the same demands and limits are kept";
    for (std::size_t i = 0; i < other.dead_band.size(); ++i) EXPECT_LT(trial.dead_band[i], 0.7 * other.dead_band[i]);
}

TEST_F(CoDesignProblem, CandidatesAreProfilesThatAreReadBackBitForBit) {
    std::mt19937_64 random(7);
    for (const char* law : {"\"stiction_compensating\"", "\"free_curve\""}) {
        const Problem problem(read({{"co_design.law", law}}));
        for (int i = 0; i < 5; ++i) {
            const profile::Profile candidate = problem.candidate(draw(problem, random));
            const profile::Profile again = profile::read_profile(write("p/candidate.toml", profile::to_toml(candidate)));
            EXPECT_EQ(profile::to_toml(again), profile::to_toml(candidate));
            const Trial a = problem.evaluate(candidate), b = problem.evaluate(again);
            EXPECT_EQ(cost(a), cost(b));
            EXPECT_EQ(a.limits.size(), b.limits.size());
        }
    }
}

TEST_F(CoDesignProblem, EveryCandidateHasACostAndFeasibleOnesAreWhatThePipelineAccepts) {
    const Problem problem(read());
    std::mt19937_64 random(3);
    for (int i = 0; i < 200; ++i) {
        const Trial trial = problem.evaluate(draw(problem, random));
        EXPECT_TRUE(std::isfinite(cost(trial)));
        EXPECT_EQ(trial.feasible(), cost(trial) < 1000.0);
    }
}

TEST_F(CoDesignProblem, CatalogueSpringsKeepTheirRows) {
    const auto copied = write("p/springs.csv", core::read_file(fixtures::shipped("pnrvsa").parent_path() / "springs/catalogue.csv"));
    const Problem problem(read({{"co_design.catalogue", "\"springs.csv\""}}));
    const spring::Catalogue& all = problem.options().catalogue;
    std::mt19937_64 random(11);
    for (int i = 0; i < 50; ++i) {
        const profile::Profile p = problem.candidate(draw(problem, random));
        for (const spring::BaseSpring* s : {&p.k_se.spring, &p.k_pe.spring}) {
            const auto& rows = all.of(s->kind);
            EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [&](const spring::CatalogueSpring& row) {
                return row.spring.rate == s->rate && row.spring.max_load == s->max_load && row.spring.wire_diameter == s->wire_diameter;
            }));
        }
    }
}

TEST_F(CoDesignProblem, MistakesNameTheirKey) {
    expect_refused(read({{"co_design.loads_Nm", "[2.1, 0.6]"}}), "co_design.loads_Nm");
    expect_refused(read({{"co_design.capstan_radius_mm", "[40.0, 25.0]"}}), "co_design.capstan_radius_mm");
    expect_refused(read({{"law.c_Nm", "0.9"}}), "co_design.travel_rad");  // no such law: nothing to take the demands from
}

}  // namespace
}  // namespace fusee::search::codesign
