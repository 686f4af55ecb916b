#include "fusee/gap/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <numeric>
#include <system_error>
#include <thread>

#include "answer.h"
#include "fusee/core/error.h"
#include "search.h"
#include "splits.h"
#include "verdict.h"
#include "workload.h"

namespace fusee::gap {

namespace {

constexpr std::size_t kLeastRows = 4;  ///< of which anything can be said: those of the paper's table I

/// TBB makes no more threads than there are cores, and fails where the system does not give them: as many as it gives at once.
unsigned threads_for(unsigned jobs) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const unsigned wanted = jobs == 0 ? cores : std::min(jobs, cores);
    std::promise<void> over;
    std::vector<std::thread> probes;
    try {
        const std::shared_future<void> end = over.get_future().share();
        while (probes.size() + 1 < wanted) probes.emplace_back([end] { end.wait(); });
    } catch (const std::system_error&) {
    }
    over.set_value();
    for (std::thread& probe : probes) probe.join();
    return static_cast<unsigned>(probes.size()) + 1;
}

/// Parts of a diagnosis, told as they are finished.
class Steps {
public:
    Steps(const DiagnoseOptions& options, const Case& bench) : options_(options) {
        const auto steps = motion_steps(bench.rows, bench.protocol);
        const double usual = std::accumulate(steps.begin(), steps.end(), 0.0) / kUsualSteps;
        if (usual > kLong) warning_ = fmt::format("; this case takes {:.2g} times as long as a usual one", usual);
    }
    void operator()(const std::string& what) {
        if (options_.progress) options_.progress(++done_, kSteps, what + warning_);
        warning_.clear();
    }

private:
    static constexpr std::size_t kSteps = 7;  // five of the search, two below
    static constexpr double kLong = 3.0;      // times the usual
    const DiagnoseOptions& options_;
    std::string warning_;
    std::size_t done_ = 0;
};

}  // namespace

Diagnosis diagnose(const Case& bench, const DiagnoseOptions& options) {
    if (bench.rows.size() < kLeastRows)
        throw core::InvalidInput("experiments", std::to_string(bench.rows.size()) + " rows",
                                 fmt::format("at least {} rows in all", kLeastRows));
    require_feasible(bench.rows, bench.protocol, kMostSteps);
    Steps told(options, bench);
    const unsigned jobs = threads_for(options.jobs);
    const Problem problem(bench);
    const Search found = search(problem, {jobs, std::ref(told)});
    const Judgement judgement = judge(problem, found);
    Answer answer(problem, found, judgement);
    answer.compare(kept_back(problem, found.best(), jobs));
    told("rows kept back");
    answer.rank();
    answer.look_ahead(jobs);
    told("next experiment");
    return answer.take();
}

}  // namespace fusee::gap
