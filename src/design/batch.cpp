#include "batch.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <pagmo/batch_evaluators/thread_bfe.hpp>
#include <pagmo/bfe.hpp>
#include <pagmo/problem.hpp>
#include <utility>

#include "fusee/core/parallel.h"

namespace fusee::design {

namespace {

/// pagmo copies problems freely: the cost itself is shared.
struct CostProblem {
    std::shared_ptr<const Cost> cost;
    pagmo::vector_double low, high;

    [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& x) const {
        const double value = (*cost)(x);
        return {std::isfinite(value) ? value : std::numeric_limits<double>::max()};
    }
    [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const { return {low, high}; }
    [[nodiscard]] pagmo::thread_safety get_thread_safety() const { return pagmo::thread_safety::constant; }
};

pagmo::problem problem_of(Cost cost, const std::vector<core::Range>& bounds) {
    CostProblem problem{std::make_shared<const Cost>(std::move(cost)), {}, {}};
    for (const core::Range& range : bounds) {
        problem.low.push_back(range.low);
        problem.high.push_back(range.high);
    }
    return pagmo::problem(problem);
}

int threads(unsigned jobs) {
    return jobs == 0 ? oneapi::tbb::info::default_concurrency() : static_cast<int>(std::min(jobs, core::kMostWorkers));
}

}  // namespace

/// pagmo's thread_bfe uses as many threads as the arena that it is called in; more of them than processors have to be allowed first.
struct Batch::Machine {
    Machine(pagmo::problem of, int threads)
        : problem(std::move(of)),
          allowed(oneapi::tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(std::max(threads, oneapi::tbb::info::default_concurrency()))),
          arena(threads) {}

    pagmo::problem problem;
    pagmo::bfe evaluator{pagmo::thread_bfe{}};
    oneapi::tbb::global_control allowed;
    oneapi::tbb::task_arena arena;
};

Batch::Batch(Cost cost, const std::vector<core::Range>& bounds, unsigned jobs)
    : machine_(std::make_unique<Machine>(problem_of(std::move(cost), bounds), threads(jobs))) {}

Batch::~Batch() = default;

std::vector<double> Batch::operator()(const std::vector<double>& rows) const {
    return machine_->arena.execute([&] { return machine_->evaluator(machine_->problem, rows); });
}

}  // namespace fusee::design
