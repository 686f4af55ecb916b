#include "refine.h"

#include <cmath>

#include "fusee/inference/screen.h"
#include "fusee/inference/search.h"

namespace fusee::inference {

Fit relaxed(const Problem& problem, Fit found, unsigned jobs) {
    if (std::abs(worst_nuisance_pull(problem, found).sigmas) <= kImpossible) return found;
    Eigen::VectorXd x = found.x;
    for (std::size_t k = 0; k < problem.build().size(); ++k)
        if (double& value = x[static_cast<Eigen::Index>(k)]; std::abs(value) > kStrained) value = 0.0;
    Fit again = fit(problem, found.causes, x, {.jobs = jobs});
    return again.log_evidence > found.log_evidence ? again : found;
}

std::vector<Guess> sides_apart(const Problem& problem, const Fit& base) {
    const auto build = static_cast<Eigen::Index>(problem.build().size());
    const Eigen::MatrixXd held = base.jacobian.leftCols(build);
    const double before = cost_of(problem, base.causes, problem.thin_residual(base.causes, base.x).cwiseQuotient(base.spread), base.x);
    std::vector<Guess> guesses;
    for (std::size_t c = 0; c < base.causes.size(); ++c) {
        if (base.causes[c].side != "both") continue;
        const int from = problem.effect_size_index(base.causes, c), own = problem.effect_size_index(base.causes, c + 1) - from;
        Guess apart{base.causes, Eigen::VectorXd(base.x.size() + own), 0.0};
        apart.causes[c].side = "agonist";
        apart.causes.push_back({base.causes[c].id, "antagonist"});
        apart.x << base.x, base.x.segment(from, own);
        apart = descend(problem, base.spread, held, std::move(apart), {.steps = kScreenRounds, .least = 0.0, .smallest = 0.2});
        if (before - apart.cost > kSecondOdds) guesses.push_back(std::move(apart));  // half of what it has to be worth
    }
    return guesses;
}

Fit searched_again(const Problem& problem, Fit found, unsigned jobs) {
    for (std::size_t c = found.causes.size(); c-- > 0 && !explained(problem, found);) {
        const Guess guess = guess_upon(problem, without(problem, found, c), found.causes[c]);
        Fit again = fit(problem, guess.causes, guess.x, {.jobs = jobs});
        if (again.log_evidence > found.log_evidence) found = std::move(again);
    }
    return found;
}

}  // namespace fusee::inference
