#include <algorithm>

#include "answer.h"
#include "fusee/inference/constants.h"
#include "next_experiment.h"

namespace fusee::diagnosis {

namespace {

/// The likely hypotheses. A refuted nominal model is not a rival: the question is then which effect comes nearest.
std::vector<NextExperiment> between_rivals(const inference::Problem& problem, const Stages& stages, unsigned jobs) {
    const inference::Search& found = stages.found;
    const bool refuted = stages.decision.verdict == VerdictKind::kUnknown && found.best().causes.empty();
    const double of_all = refuted ? 1.0 - found.probability[found.null] : 1.0;
    std::vector<const inference::Fit*> rivals;
    std::vector<double> probabilities;
    for (std::size_t h = 0; h < found.fits.size() && rivals.size() < inference::kMostRivals; ++h) {
        const std::vector<std::size_t>& alike = stages.decision.indistinct;
        const bool is_alike = std::find(alike.begin(), alike.end(), h) != alike.end();
        const double probability = std::max(found.probability[h] / of_all, is_alike ? inference::kSmallLeak : 0.0);
        if ((refuted && h == found.null) || probability < inference::kSmallLeak) continue;
        rivals.push_back(&found.fits[h]);
        probabilities.push_back(probability);
    }
    return next_experiments(problem, rivals, probabilities, jobs);
}

}  // namespace

std::vector<NextExperiment> plan(const inference::Problem& problem, const Stages& stages, unsigned jobs) {
    if (stages.terms) {  // what would confirm the form
        const std::vector<double> even{0.5, 0.5};
        return next_experiments(problem, {&stages.shown(), &stages.null()}, even, jobs);
    }
    if (!stages.decision.unseen.empty()) return showing_experiments(problem, stages.null(), stages.decision.unseen, jobs);
    return between_rivals(problem, stages, jobs);
}

}  // namespace fusee::diagnosis
