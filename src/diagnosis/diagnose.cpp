#include "fusee/diagnosis/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <numeric>
#include <optional>
#include <system_error>
#include <thread>

#include "answer.h"
#include "fusee/core/error.h"
#include "fusee/effects/joint.h"
#include "fusee/inference/pursue.h"
#include "fusee/inference/search.h"
#include "fusee/inference/splits.h"
#include "verdict.h"
#include "workload.h"

namespace fusee::diagnosis {

namespace {

constexpr std::size_t kLeastRows = 4;  ///< least number of rows of a diagnosis: that of the paper's table I

constexpr double kLong = 3.0;  ///< times the usual duration, from which the reader is told

/// Progress of a diagnosis.
class Steps {
public:
    explicit Steps(const DiagnoseOptions& options) : options_(options) {}
    void operator()(const std::string& what) {
        if (options_.progress) options_.progress(++done_, kSteps, what);
    }

private:
    static constexpr std::size_t kSteps = 8;  // five of the search, three below
    const DiagnoseOptions& options_;
    std::size_t done_ = 0;
};

/// The same options; the first part says so where the case takes long.
DiagnoseOptions with_warning(const gap_case::Case& gap_case, const DiagnoseOptions& options) {
    const auto steps = motion_steps(gap_case.rig, gap_case.rows, gap_case.protocol);
    const double usual = std::accumulate(steps.begin(), steps.end(), 0.0) / kUsualSteps;
    if (usual <= kLong || !options.progress) return options;
    const std::string warning = fmt::format("; this case takes {:.2g} times as long as a usual one", usual);
    return {options.jobs, [=, tell = options.progress](std::size_t done, std::size_t total, const std::string& what) {
                tell(done, total, done == 1 ? what + warning : what);
            }};
}

/// Generic terms where the library explains nothing, or only two of its effects together do: one unknown effect often looks like two known
/// ones. One effect competes with the terms that resemble it. The first term has to beat every hypothesis of the library.
std::optional<inference::FoundTerms> terms_of(const inference::Problem& problem, const inference::Search& found, VerdictKind verdict,
                                              unsigned jobs) {
    const bool named = verdict == VerdictKind::kIdentified || verdict == VerdictKind::kAmbiguous;
    const std::vector<inference::Cause> terms = named && found.best().causes.size() == 1
                                                    ? inference::terms_like(problem, found.best().causes.front().id)
                                                    : inference::possible_terms(problem);
    if (terms.empty() || (named && found.best().causes.empty())) return std::nullopt;
    const inference::Fit& null = found.fits[found.null];
    const double best = null.log_evidence - found.log_posterior[found.null];  // of the library, its odds included
    return inference::pursue_terms(problem, null, best, terms, {.jobs = jobs, .progress = {}});
}

}  // namespace

Diagnosis diagnose(const inference::Model& model, const Subject& subject, const DiagnoseOptions& options) {
    Steps progress(options);
    const unsigned jobs = options.jobs;
    const inference::Problem problem(model);
    const inference::Search found = search(problem, {jobs, std::ref(progress)});
    const Verdict verdict = judge(problem, found);
    Answer answer(subject, problem, found, verdict);
    const inference::Fit& null = found.fits[found.null];
    const std::optional<inference::FoundTerms> terms = terms_of(problem, found, verdict.verdict, jobs);
    if (terms) answer.name(*terms);
    progress("generic terms");
    answer.compare(held_out(problem, null, answer.shown(), jobs));
    progress("held-out rows");
    answer.rank();
    answer.plan_next_experiment(jobs);
    progress("next experiment");
    return answer.take();
}

Diagnosis diagnose(const gap_case::Case& gap_case, const DiagnoseOptions& options) {
    if (gap_case.rows.size() < kLeastRows)
        throw core::InvalidInput("experiments", std::to_string(gap_case.rows.size()) + " rows",
                                 fmt::format("at least {} rows in all", kLeastRows));
    require_feasible(gap_case.rig, gap_case.rows, gap_case.protocol, kMostSteps);
    return diagnose(effects::Joint(gap_case), {gap_case.name, gap_case.sha256}, with_warning(gap_case, options));
}

}  // namespace fusee::diagnosis
