// Algorithm 1's cost in closed form beside the paper's numeric way on the same designs, one core; and the search around it:
//   cmake -S . -B build-bench -G Ninja -DFUSEE_BUILD_BENCH=ON && cmake --build build-bench --target run_bench_design
// An iteration is one evaluation: the cost of one (k, u, C) with 20 torques. The designs are feasible, so that the second stage is timed.
#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "design/numeric_algorithm_1.h"
#include "fusee/design/algorithm_1.h"
#include "fusee/design/evolution.h"

using namespace fusee::design;

namespace {

Algorithm1 paper_algorithm() {
    Algorithm1Options options;
    options.wanted_travel = 1.0;
    return {options, {0.28, 1.0, {0.6, 1.0}, 2.21}};
}

/// Around the shipped design; each a little different, so that nothing can be kept from one evaluation to the next.
std::vector<std::array<double, 3>> designs() {
    std::vector<std::array<double, 3>> all;
    for (int i = 0; i < 64; ++i) all.push_back({0.15 + 0.005 * i, 0.001 + 0.0015 * i, 0.35 - 0.004 * i});
    return all;
}

template <class Evaluate>
void evaluate_each(benchmark::State& state, const Evaluate& cost) {
    const auto all = designs();
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(cost(all[i++ % all.size()]));
    state.SetItemsProcessed(state.iterations());
}

void BM_Algorithm1Closed(benchmark::State& state) { evaluate_each(state, paper_algorithm()); }
BENCHMARK(BM_Algorithm1Closed)->Unit(benchmark::kNanosecond);

void BM_Algorithm1Numeric(benchmark::State& state) { evaluate_each(state, NumericAlgorithm1(paper_algorithm())); }
BENCHMARK(BM_Algorithm1Numeric)->Unit(benchmark::kNanosecond);

/// 100,000 evaluations: 50 members, the first population and 1999 generations.
void evolve_100000(benchmark::State& state, const Cost& cost, int population, int generations) {
    EvolutionOptions options;
    options.bounds = paper_algorithm().bounds();
    options.population = population;
    options.generations = generations;
    options.jobs = static_cast<unsigned>(state.range(0));
    std::size_t evaluations = 0;
    for (auto _ : state) evaluations = evolve(cost, options).evaluations;
    state.counters["evaluations"] = static_cast<double>(evaluations);
}
void BM_EvolveClosed(benchmark::State& state) { evolve_100000(state, paper_algorithm(), 50, 1999); }
BENCHMARK(BM_EvolveClosed)->ArgName("jobs")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_EvolveNumeric(benchmark::State& state) { evolve_100000(state, NumericAlgorithm1(paper_algorithm()), 50, 19); }
BENCHMARK(BM_EvolveNumeric)->ArgName("jobs")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
