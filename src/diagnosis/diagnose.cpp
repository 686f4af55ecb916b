#include "fusee/diagnosis/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "absorption.h"
#include "answer.h"
#include "fusee/core/error.h"
#include "fusee/effects/joint.h"
#include "fusee/inference/screen.h"
#include "isolability.h"
#include "rivals.h"
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

void require_diagnosable(const gap_case::Case& gap_case) {
    if (gap_case.rows.size() < kLeastRows)
        throw core::InvalidInput("experiments", std::to_string(gap_case.rows.size()) + " rows",
                                 fmt::format("at least {} rows in all", kLeastRows));
    require_feasible(gap_case.rig, gap_case.rows, gap_case.protocol, kMostSteps);
}

}  // namespace

Stages stages_of(const inference::Problem& problem, const DiagnoseOptions& options) {
    Steps progress(options);
    const unsigned jobs = options.jobs;
    Stages stages;
    stages.found = search(problem, {jobs, std::ref(progress)});
    stages.isolability = isolability(problem, stages.null(), inference::possible_causes(problem), jobs);
    stages.found = with_fits(problem, std::move(stages.found), class_rivals(problem, stages.found, stages.isolability, jobs), jobs);
    Scrutiny scrutiny = scrutinize(problem, stages.found, jobs);
    stages.terms = terms_of(problem, stages.found, scrutiny, jobs);
    if (stages.terms && !stages.found.best().causes.empty()) {
        inference::Reconsidered again = reconsidered(problem, std::move(stages.found), std::move(*stages.terms), jobs);
        stages.found = std::move(again.found);
        stages.terms = std::move(again.terms);
        scrutiny = scrutinize(problem, stages.found, jobs);
    }
    if (!stages.terms && !scrutiny.holds()) stages.part = standing_part(problem, stages.found, jobs);
    progress("generic terms");
    stages.decision = decide(problem, stages.found, scrutiny, stages.terms, stages.part.has_value(), stages.isolability);
    stages.held_out = held_out(problem, stages.null(), stages.shown(), jobs);
    stages.absorption = absorption_of(problem, stages, jobs);
    progress("held-out rows");
    stages.next = plan(problem, stages, jobs);
    progress("next experiment");
    return stages;
}

Diagnosis diagnose_model(const inference::Model& model, const Subject& subject, const DiagnoseOptions& options) {
    const inference::Problem problem(model);
    return answer_of(subject, problem, stages_of(problem, options));
}

Diagnosis diagnose(const gap_case::Case& gap_case, const DiagnoseOptions& options) {
    require_diagnosable(gap_case);
    return diagnose_model(effects::Joint(gap_case), {gap_case.name, gap_case.sha256}, with_warning(gap_case, options));
}

Against against(const gap_case::Case& other, const Diagnosis& found, const DiagnoseOptions& options) {
    require_diagnosable(other);
    return against(effects::Joint(other), {other.name, other.sha256}, found, with_warning(other, options));
}

}  // namespace fusee::diagnosis
