#include "fusee/design/evolution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/population.hpp>
#include <stdexcept>
#include <thread>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "pipeline/fixture.h"

namespace fusee::design {
namespace {

/// Rosenbrock's valley in three variables: least cost 0 at (1, 1, 1).
double valley(std::span<const double> x) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) sum += 100.0 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1.0 - x[i], 2);
    return sum;
}

EvolutionOptions in_valley() {
    EvolutionOptions options;
    options.bounds = {{-2.0, 2.0}, {-2.0, 3.0}, {-1.0, 4.0}};
    options.generations = 300;
    options.seed = 7;
    options.problem = "valley";
    return options;
}

void expect_same_bits(const EvolutionResult& a, const EvolutionResult& b) {
    EXPECT_EQ(a.best, b.best);
    EXPECT_EQ(a.cost, b.cost);
    EXPECT_EQ(a.history, b.history);
    EXPECT_EQ(a.evaluations, b.evaluations);
}

TEST(Evolution, FindsTheFloorOfRosenbrocksValley) {
    const EvolutionResult found = evolve(valley, in_valley());
    // 12,000 evaluations in a smooth valley: the last generations gain about half a digit each ten.
    EXPECT_LT(found.cost, 1e-12);
    for (const double x : found.best) EXPECT_NEAR(x, 1.0, 1e-5);
    EXPECT_EQ(found.evaluations, 40u * 301u);
    EXPECT_EQ(found.generations, 300);
    EXPECT_FALSE(found.interrupted);
    ASSERT_EQ(found.history.size(), 301u);
    EXPECT_TRUE(std::is_sorted(found.history.rbegin(), found.history.rend())) << "the best never gets worse";
    EXPECT_EQ(found.history.back(), found.cost);
}

TEST(Evolution, SameBitsForAnyNumberOfThreads) {
    EvolutionOptions options = in_valley();
    options.generations = 40;
    options.jobs = 1;
    const EvolutionResult one = evolve(valley, options);
    for (const unsigned jobs : {2u, 4u, 7u, 0u}) {
        options.jobs = jobs;
        expect_same_bits(evolve(valley, options), one);
    }
}

TEST(Evolution, AnotherSeedIsAnotherSearch) {
    EvolutionOptions options = in_valley();
    options.generations = 5;
    const EvolutionResult one = evolve(valley, options);
    options.seed = 8;
    EXPECT_NE(evolve(valley, options).best, one.best);
}

TEST(Evolution, EveryTrialStaysInTheBoxAndIsSeen) {
    EvolutionOptions options = in_valley();
    options.bounds[1] = {-0.5, -0.5};  // held
    options.generations = 50;
    std::size_t seen = 0;
    double least = std::numeric_limits<double>::max();
    options.observe = [&](std::span<const double> x, double cost) {
        ++seen;
        least = std::min(least, cost);
        for (std::size_t j = 0; j < 3; ++j) EXPECT_TRUE(options.bounds[j].holds(x[j])) << x[j];
    };
    const EvolutionResult found = evolve(valley, options);
    EXPECT_EQ(seen, found.evaluations);
    EXPECT_EQ(least, found.cost);
    EXPECT_EQ(found.best[1], -0.5);
}

TEST(Evolution, InfiniteAndNanCostsAreTheWorst) {
    EvolutionOptions options = in_valley();
    const auto holed = [](std::span<const double> x) {
        if (x[0] < 0.0) return std::numeric_limits<double>::quiet_NaN();
        if (x[1] < 0.0) return -std::numeric_limits<double>::infinity();
        return valley(x);
    };
    EXPECT_LT(evolve(holed, options).cost, 1e-12);
    options.generations = 1;
    EXPECT_EQ(evolve([](auto) { return std::numeric_limits<double>::infinity(); }, options).cost, std::numeric_limits<double>::max());
}

TEST(Evolution, EndsWhenThePopulationAgrees) {
    EvolutionOptions options = in_valley();
    options.tolerance = 1e-6;
    const EvolutionResult found = evolve(valley, options);
    EXPECT_LT(found.generations, 300);
    EXPECT_FALSE(found.interrupted);
    EXPECT_LT(found.cost, 1e-6);
}

TEST(Evolution, ACostThatThrowsEndsTheSearch) {
    const auto broken = [](std::span<const double>) -> double { throw std::runtime_error("no cost"); };
    EXPECT_THROW((void)evolve(broken, in_valley()), std::runtime_error);
}

/// pagmo's own searches on the same cost.
struct Valley {
    [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& x) const { return {valley(x)}; }
    [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const { return {{-2, -2, -1}, {2, 3, 4}}; }
};

TEST(Evolution, PagmosSadeAndCmaesFindTheSameFloor) {
    const EvolutionResult ours = evolve(valley, in_valley());
    for (const pagmo::algorithm& theirs : {pagmo::algorithm(pagmo::sade(600, 2, 1, 1e-14, 1e-14, false, 5)),
                                           pagmo::algorithm(pagmo::cmaes(300, -1, -1, -1, -1, 0.5, 1e-14, 1e-14, false, true, 5))}) {
        const pagmo::population end = theirs.evolve(pagmo::population(pagmo::problem(Valley{}), 40, 5u));
        EXPECT_NEAR(end.champion_f()[0], ours.cost, 1e-9) << theirs.get_name();
        for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(end.champion_x()[j], ours.best[j], 1e-4) << theirs.get_name();
    }
}

class Checkpoint : public fixtures::TempFolder {
protected:
    EvolutionOptions stored() const {
        EvolutionOptions options = in_valley();
        options.generations = 60;
        options.checkpoint = folder_ / "valley.checkpoint";
        return options;
    }
    /// As if Ctrl-C came after generation `number`.
    static EvolutionResult stopped_after(EvolutionOptions options, int number) {
        int done = 0;
        options.progress = [&](int generation, double) { done = generation; };
        options.stop = [&] { return done == number; };
        return evolve(valley, options);
    }
};

TEST_F(Checkpoint, AStoppedSearchKeepsTheBestAndGoesOnBitForBit) {
    EvolutionOptions unstored = stored();
    unstored.checkpoint.clear();
    const EvolutionResult whole = evolve(valley, unstored);
    EvolutionOptions options = stored();
    const EvolutionResult part = stopped_after(options, 33);
    EXPECT_TRUE(part.interrupted);
    EXPECT_EQ(part.generations, 33);
    EXPECT_EQ(part.cost, whole.history[33]);
    options.resume = true;
    options.jobs = 3;
    expect_same_bits(evolve(valley, options), whole);
    expect_same_bits(evolve(valley, options), whole);  // nothing is left to do
}

TEST_F(Checkpoint, AKilledSearchGoesOnFromItsLastFile) {
    EvolutionOptions options = stored();
    const EvolutionResult whole = evolve(valley, options);
    std::filesystem::remove(options.checkpoint);
    std::string at_20;
    options.progress = [&](int generation, double) {
        if (generation == 21) at_20 = core::read_file(options.checkpoint);
    };
    (void)evolve(valley, options);
    core::write_file(options.checkpoint, at_20);
    options.progress = {};
    options.resume = true;
    expect_same_bits(evolve(valley, options), whole);
}

TEST_F(Checkpoint, ResumeWithoutAFileBeginsAnew) {
    EvolutionOptions options = stored();
    const EvolutionResult whole = evolve(valley, options);
    std::filesystem::remove(options.checkpoint);
    options.resume = true;
    expect_same_bits(evolve(valley, options), whole);
}

TEST_F(Checkpoint, OfAnotherSearchIsRefusedByName) {
    (void)evolve(valley, stored());
    EvolutionOptions seed = stored(), box = stored(), size = stored(), problem = stored(), weight = stored(), crossover = stored();
    seed.seed = 8;
    box.bounds[2].high = 5.0;
    size.population = 41;
    problem.problem = "hill";
    weight.weight = 0.6;
    crossover.crossover = 0.8;
    const std::pair<EvolutionOptions, std::string> cases[] = {{seed, "seed"},       {box, "bounds"},    {size, "population"},
                                                              {problem, "problem"}, {weight, "weight"}, {crossover, "crossover"}};
    for (auto [options, name] : cases) {
        options.resume = true;
        try {
            (void)evolve(valley, options);
            ADD_FAILURE() << name;
        } catch (const core::InvalidInput& e) {
            EXPECT_EQ(e.field(), options.checkpoint.string() + ": " + name);
        }
    }
}

TEST_F(Checkpoint, DamagedFilesAreRefused) {
    EvolutionOptions options = stored();
    (void)evolve(valley, options);
    options.resume = true;
    const std::string good = core::read_file(options.checkpoint);
    const auto replaced = [&](const std::string& what, const std::string& by) {
        std::string text = good;
        const auto at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return text.replace(at, what.size(), by);
    };
    const std::string bad[] = {"",
                               "no json",
                               "[]",
                               std::string(100'000, '['),
                               replaced("\"costs\": [\n  ", "\"costs\": [\n  1e400, "),
                               good.substr(0, good.size() / 2),
                               replaced("fusee evolution 1", "fusee evolution 2"),
                               replaced("\"generation\": 60", "\"generation\": 59"),
                               replaced("\"generation\": 60", "\"generation\": \"sixty\""),
                               replaced("\"members\": [\n  ", "\"members\": [\n  77.0, "),
                               replaced("\"members\": [\n  ", "\"members\": [\n  null, ")};
    for (const std::string& text : bad) {
        core::write_file(options.checkpoint, text);
        EXPECT_THROW((void)evolve(valley, options), core::IoError) << text.substr(0, 200);
    }
    options.checkpoint = folder_ / "no such folder" / "valley.checkpoint";
    EXPECT_THROW((void)evolve(valley, options), core::IoError);
}

TEST(Evolution, WrongOptionsAreNamed) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    using Spoil = void (*)(EvolutionOptions&);
    const std::pair<std::string, Spoil> cases[] = {
        {"bounds", [](EvolutionOptions& o) { o.bounds.clear(); }},
        {"bounds[0].low", [](EvolutionOptions& o) { o.bounds[0].low = kNan; }},
        {"bounds[2].high", [](EvolutionOptions& o) { o.bounds[2].high = -3.0; }},
        {"population", [](EvolutionOptions& o) { o.population = 7; }},
        {"generations", [](EvolutionOptions& o) { o.generations = 0; }},
        {"weight", [](EvolutionOptions& o) { o.weight = 0.0; }},
        {"weight", [](EvolutionOptions& o) { o.weight = 2.5; }},
        {"crossover", [](EvolutionOptions& o) { o.crossover = 1.1; }},
        {"tolerance", [](EvolutionOptions& o) { o.tolerance = -1.0; }},
        {"checkpoint_every", [](EvolutionOptions& o) { o.checkpoint_every = 0; }},
        {"resume", [](EvolutionOptions& o) { o.resume = true; }},
    };
    for (const auto& [field, spoil] : cases) {
        EvolutionOptions options = in_valley();
        spoil(options);
        try {
            (void)evolve(valley, options);
            ADD_FAILURE() << field;
        } catch (const core::InvalidInput& e) {
            EXPECT_EQ(e.field(), field);
        }
    }
}

}  // namespace
}  // namespace fusee::design
