#include "verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fusee/inference/interval.h"

namespace fusee::diagnosis {

namespace {

constexpr double kRival = 0.08;  ///< least probability of an alternative that counts
constexpr double kSlip = 1.5;    ///< spread of a row that sticks and slips
constexpr double kSlips = 0.25;  ///< share of such rows from which an experiment is no evidence against the model

/// Share of the rows of an experiment whose prediction is ill-conditioned.
double share_of_slips(const inference::Problem& problem, const inference::Fit& fit, std::size_t experiment) {
    double slips = 0.0, rows = 0.0;
    for (int i = 0; i < fit.spread.size(); ++i)
        if (problem.experiment_of(i) == experiment) {
            slips += fit.spread[i] > kSlip ? 1.0 : 0.0;
            rows += 1.0;
        }
    return rows > 0.0 ? slips / rows : 0.0;
}

/// Findings on the best hypothesis.
struct Scrutiny {
    std::vector<std::string> remarks;
    bool unexplained = false;
    bool evidence = false;  ///< an experiment can be predicted row by row
};

void look_at_experiments(Scrutiny& said, const inference::Problem& problem, const inference::Fit& best) {
    const std::vector<double> left = misfits(problem, best.seen());
    for (std::size_t e = 0; e < left.size(); ++e) {
        const inference::Experiment& experiment = problem.experiments()[e];
        const double misfit = left[e], limit = experiment.unexplained;
        if (misfit <= limit) {
            said.evidence = said.evidence || experiment.rows > 0;
            continue;
        }
        if (const double share = share_of_slips(problem, best, e); share > kSlips) {
            said.remarks.push_back(
                fmt::format("{}: {:.0f} % of the rows stick and slip, which cannot be predicted row by row ({:.1f} "
                            "sigma): not counted as evidence against the model",
                            experiment.name, 100.0 * share, misfit));
            continue;
        }
        said.unexplained = true;
        said.remarks.push_back(fmt::format("{}: the best hypothesis leaves a gap of {:.1f} sigma; a correct model leaves at most {:.2f}",
                                           experiment.name, misfit, limit));
    }
}

void look_at_tolerances(Scrutiny& said, const inference::Problem& problem, const inference::Fit& best) {
    const inference::WorstNuisancePull most = worst_nuisance_pull(problem, best);
    if (std::abs(most.sigmas) <= inference::kImpossible) return;
    said.unexplained = true;
    said.remarks.push_back(
        fmt::format("{}: the best hypothesis needs a deviation of {:+.1f} tolerance sigmas; no effect of the library explains that",
                    problem.build()[most.parameter].name, most.sigmas));
}

/// A contradicted single effect is refuted. A pair that leads although the contradiction cost it its odds is still better than every other
/// hypothesis; what only looks like two effects is found by comparing it with generic terms.
void look_at_sizes(Scrutiny& said, const inference::Problem& problem, const inference::Search& search) {
    const inference::Fit& best = search.best();
    for (const inference::Cause& cause : inference::contradicted(problem, best, search.left_out.front())) {
        said.unexplained = said.unexplained || best.causes.size() < 2;
        said.remarks.push_back(fmt::format("{} ({}): refits without one experiment each disagree on its size", cause.id, cause.side));
    }
    for (const inference::Cause& cause : inference::at_bounds(problem, best)) {
        said.unexplained = true;
        said.remarks.push_back(
            fmt::format("{} ({}): its size is at a bound of its law, so the true cause is another one", cause.id, cause.side));
    }
}

VerdictKind verdict_of(const Scrutiny& said, const inference::Search& search) {
    if (said.unexplained || !said.evidence) return VerdictKind::kUnknown;
    const bool rivalled = search.probability.size() > 1 && search.probability[1] >= kRival;  // they fall
    if (search.probability.front() < kSure && rivalled) return VerdictKind::kAmbiguous;
    return search.best().causes.empty() ? VerdictKind::kNone : VerdictKind::kIdentified;
}

}  // namespace

Verdict judge(const inference::Problem& problem, const inference::Search& search) {
    Scrutiny said;
    look_at_experiments(said, problem, search.best());
    look_at_tolerances(said, problem, search.best());
    look_at_sizes(said, problem, search);
    return {verdict_of(said, search), std::move(said.remarks)};
}

}  // namespace fusee::diagnosis
