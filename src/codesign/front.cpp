#include "front.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/batch_evaluators/thread_bfe.hpp>
#include <pagmo/bfe.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <pagmo/utils/multi_objective.hpp>

#include "fusee/core/error.h"
#include "fusee/core/parallel.h"

namespace fusee::codesign {

namespace {

constexpr unsigned kPart = 5;                                                      // generations between two looks at progress and Ctrl-C
constexpr double kCrossover = 0.9, kCrossoverIndex = 10.0, kMutationIndex = 20.0;  // Deb et al. 2002

/// pagmo copies problems freely: the costs themselves are shared.
struct CostsProblem {
    std::shared_ptr<const Costs> costs;
    pagmo::vector_double low, high;

    [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& x) const {
        const auto values = (*costs)(x);
        return {values[0], values[1]};
    }
    [[nodiscard]] pagmo::vector_double::size_type get_nobj() const { return 2; }
    [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const { return {low, high}; }
    [[nodiscard]] pagmo::thread_safety get_thread_safety() const { return pagmo::thread_safety::constant; }
};

void validate(const FrontOptions& o) {
    if (o.population < 8 || o.population % 4 != 0)
        throw core::InvalidInput("design.population", fmt::format("{}", o.population), "a multiple of 4, at least 8, for a Pareto front");
    core::require_within("design.generations", o.generations, 1, 1'000'000);
}

pagmo::population first_population(const Costs& costs, const FrontOptions& o, const pagmo::bfe& evaluator) {
    CostsProblem problem{std::make_shared<const Costs>(costs), {}, {}};
    for (const core::Range& range : o.bounds) {
        problem.low.push_back(range.low);
        problem.high.push_back(range.high);
    }
    pagmo::population all(pagmo::problem(problem), evaluator, static_cast<std::size_t>(o.population), o.seed);
    for (std::size_t i = 0; i < std::min(o.seeds.size(), all.size()); ++i) all.set_x(i, o.seeds[i]);
    return all;
}

double least_first(const pagmo::population& population) {
    double least = population.get_f().front()[0];
    for (const auto& f : population.get_f()) least = std::min(least, f[0]);
    return least;
}

Front front_of(const pagmo::population& population) {
    Front front;
    const auto& f = population.get_f();
    std::vector<std::size_t> best = pagmo::non_dominated_front_2d(f);
    std::stable_sort(best.begin(), best.end(), [&](std::size_t a, std::size_t b) { return f[a] < f[b]; });
    best.erase(std::unique(best.begin(), best.end(), [&](std::size_t a, std::size_t b) { return f[a] == f[b]; }), best.end());
    for (const std::size_t i : best) front.members.push_back(population.get_x()[i]);
    front.evaluations = population.get_problem().get_fevals();
    return front;
}

/// NSGA-II crosses and mutates only numbers that have a range.
class Free {
public:
    explicit Free(const std::vector<core::Range>& bounds) : bounds_(bounds) {
        for (std::size_t i = 0; i < bounds.size(); ++i)
            if (bounds[i].low < bounds[i].high) free_.push_back(i);
    }
    [[nodiscard]] bool all() const { return free_.size() == bounds_.size(); }
    [[nodiscard]] bool none() const { return free_.empty(); }

    /// The numbers that have a range.
    template <class Value>
    [[nodiscard]] std::vector<Value> of(const std::vector<Value>& values) const {
        std::vector<Value> some;
        for (const std::size_t i : free_) some.push_back(values[i]);
        return some;
    }
    /// All of them, the others at their only value.
    [[nodiscard]] std::vector<double> with_fixed(std::span<const double> some) const {
        std::vector<double> values;
        for (const core::Range& range : bounds_) values.push_back(range.low);
        for (std::size_t i = 0; i < free_.size(); ++i) values[free_[i]] = some[i];
        return values;
    }

private:
    const std::vector<core::Range>& bounds_;
    std::vector<std::size_t> free_;
};

Front search(const Costs& costs, const FrontOptions& o) {
    const pagmo::bfe evaluator{pagmo::thread_bfe{}};
    pagmo::population population = first_population(costs, o, evaluator);
    int done = 0;
    bool stopped = false;
    while (done < o.generations && !stopped) {
        const unsigned part = std::min(kPart, static_cast<unsigned>(o.generations - done));
        // A stream of its own for each part, so that where a run is parted from outside does not matter.
        pagmo::nsga2 algorithm(part, kCrossover, kCrossoverIndex, 1.0 / static_cast<double>(o.bounds.size()), kMutationIndex,
                               o.seed + static_cast<unsigned>(done) + 1);
        algorithm.set_bfe(evaluator);
        population = algorithm.evolve(population);
        done += static_cast<int>(part);
        if (o.progress) o.progress(done, least_first(population));
        stopped = o.stop && o.stop();
    }
    Front front = front_of(population);
    front.generations = done;
    front.interrupted = done < o.generations;
    return front;
}

}  // namespace

Front find_front(const Costs& costs, const FrontOptions& options) {
    validate(options);
    const Free free(options.bounds);
    Front front;
    if (free.all()) {
        core::with_threads(options.jobs, [&] { front = search(costs, options); });
        return front;
    }
    if (free.none()) return {.members = {free.with_fixed({})}, .evaluations = 0};
    FrontOptions of_free = options;
    of_free.bounds = free.of(options.bounds);
    for (std::vector<double>& seed : of_free.seeds) seed = free.of(seed);
    const Costs costs_of_free = [&](std::span<const double> some) { return costs(free.with_fixed(some)); };
    core::with_threads(options.jobs, [&] { front = search(costs_of_free, of_free); });
    for (std::vector<double>& member : front.members) member = free.with_fixed(member);
    return front;
}

}  // namespace fusee::codesign
