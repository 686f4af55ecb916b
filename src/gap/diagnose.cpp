#include "fusee/gap/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "answer.h"
#include "fusee/core/error.h"
#include "search.h"
#include "splits.h"
#include "verdict.h"

namespace fusee::gap {

namespace {

constexpr std::size_t kLeastRows = 4;  ///< of which anything can be said: those of the paper's table I

/// Parts of a diagnosis, told as they are finished.
class Steps {
public:
    explicit Steps(const DiagnoseOptions& options) : options_(options) {}
    void operator()(const std::string& what) {
        if (options_.progress) options_.progress(++done_, kSteps, what);
    }

private:
    static constexpr std::size_t kSteps = 7;  // five of the search, two below
    const DiagnoseOptions& options_;
    std::size_t done_ = 0;
};

}  // namespace

Diagnosis diagnose(const Case& bench, const DiagnoseOptions& options) {
    if (bench.rows.size() < kLeastRows)
        throw core::InvalidInput("experiments", std::to_string(bench.rows.size()) + " rows",
                                 fmt::format("at least {} rows in all", kLeastRows));
    Steps told(options);
    const unsigned jobs = options.jobs == 0 ? std::max(1U, std::thread::hardware_concurrency()) : options.jobs;
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
