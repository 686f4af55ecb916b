#include "refine.h"

#include <cmath>

#include "fusee/inference/screen.h"
#include "fusee/inference/search.h"

namespace fusee::inference {

namespace {

/// The fit without cause `c`, where it is: not fitted again.
Fit without(const Problem& problem, const Fit& fit, std::size_t c) {
    const int from = problem.effect_size_index(fit.causes, c), to = problem.effect_size_index(fit.causes, c + 1),
              left = static_cast<int>(fit.x.size()) - to;
    Fit base = fit;
    base.causes.erase(base.causes.begin() + static_cast<std::ptrdiff_t>(c));
    base.x.resize(fit.x.size() - (to - from));
    base.x << fit.x.head(from), fit.x.tail(left);
    base.jacobian = joined(fit.jacobian.leftCols(from), fit.jacobian.rightCols(left));
    return base;
}

}  // namespace

Fit relaxed(const Problem& problem, Fit found, unsigned jobs) {
    if (std::abs(worst_nuisance_pull(problem, found).sigmas) <= kImpossible) return found;
    Eigen::VectorXd x = found.x;
    for (std::size_t k = 0; k < problem.build().size(); ++k)
        if (double& value = x[static_cast<Eigen::Index>(k)]; std::abs(value) > kStrained) value = 0.0;
    Fit again = fit(problem, found.causes, x, {.jobs = jobs});
    return again.log_evidence > found.log_evidence ? again : found;
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
