#include <algorithm>
#include <memory>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/nsga2.hpp>
#include <pagmo/batch_evaluators/thread_bfe.hpp>
#include <pagmo/bfe.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <pagmo/utils/multi_objective.hpp>

#include "front.h"

namespace fusee::search::codesign {

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

Front evolve(const Costs& costs, const FrontOptions& o) {
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

}  // namespace fusee::search::codesign

extern "C" void fusee_nsga2(const fusee::search::codesign::Costs& costs, const fusee::search::codesign::FrontOptions& options,
                            fusee::search::codesign::Front& front) {
    front = fusee::search::codesign::evolve(costs, options);
}
