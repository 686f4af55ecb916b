#include "fusee/diagnosis/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <numeric>
#include <system_error>
#include <thread>

#include "answer.h"
#include "fusee/core/error.h"
#include "fusee/inference/search.h"
#include "fusee/inference/splits.h"
#include "verdict.h"
#include "workload.h"

namespace fusee::diagnosis {

namespace {

constexpr std::size_t kLeastRows = 4;  ///< of which anything can be said: those of the paper's table I

/// Parts of a diagnosis, told as they are finished.
class Steps {
public:
    Steps(const DiagnoseOptions& options, const gap_case::Case& bench) : options_(options) {
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

Diagnosis diagnose(const gap_case::Case& bench, const DiagnoseOptions& options) {
    if (bench.rows.size() < kLeastRows)
        throw core::InvalidInput("experiments", std::to_string(bench.rows.size()) + " rows",
                                 fmt::format("at least {} rows in all", kLeastRows));
    require_feasible(bench.rows, bench.protocol, kMostSteps);
    Steps told(options, bench);
    const unsigned jobs = options.jobs;
    const inference::Problem problem(bench);
    const inference::Search found = search(problem, {jobs, std::ref(told)});
    const Judgement judgement = judge(problem, found);
    Answer answer(problem, found, judgement);
    answer.compare(kept_back(problem, found.best(), jobs));
    told("rows kept back");
    answer.rank();
    answer.look_ahead(jobs);
    told("next experiment");
    return answer.take();
}

}  // namespace fusee::diagnosis
