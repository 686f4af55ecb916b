#include "refine.h"

#include <algorithm>
#include <cmath>

#include "fusee/inference/screen.h"
#include "fusee/inference/search.h"

namespace fusee::inference {

bool explained(const Problem& problem, const Fit& fit) {
    if (std::abs(worst_nuisance_pull(problem, fit).sigmas) > kStretched) return false;
    const std::vector<double> misfit = misfits(problem, fit.seen());
    return std::all_of(misfit.begin(), misfit.end(), [](double t) { return t < kNothingLeft; });
}

bool sizes_stand(const Problem& problem, const Fit& fit) {
    for (std::size_t c = 0; c < fit.causes.size(); ++c) {
        const int k = problem.effect_size_index(fit.causes, c);
        const Effect& effect = problem.effect(fit.causes[c].id);
        const double least = std::max(problem.least_size(effect), kStandsOff * std::sqrt(fit.covariance(k, k)));
        if (!effect.is_limit() && std::abs(fit.x[k]) < least) return false;
    }
    return true;
}

Fit relaxed(const Problem& problem, Fit found, unsigned jobs) {
    if (std::abs(worst_nuisance_pull(problem, found).sigmas) <= kImpossible) return found;
    Eigen::VectorXd x = found.x;
    for (std::size_t k = 0; k < problem.build().size(); ++k)
        if (double& value = x[static_cast<Eigen::Index>(k)]; std::abs(value) > kStrained) value = 0.0;
    Fit again = fit(problem, found.causes, x, {.jobs = jobs});
    return again.log_evidence > found.log_evidence ? again : found;
}

Fit restarted(const Problem& problem, Fit found, unsigned jobs) {
    const auto build = static_cast<Eigen::Index>(problem.build().size());
    Eigen::VectorXd x = found.x;
    x.head(build).setZero();
    std::vector<Guess> guesses{{found.causes, x, 0.0}};
    const int first = problem.has_figures() ? 0 : 1;  // the usual size of a simulator's effect is a guess
    for (std::size_t c = 0; c < found.causes.size(); ++c)
        for (int k = problem.effect_size_index(found.causes, c) + first; k < problem.effect_size_index(found.causes, c + 1); ++k)
            for (const double factor : {kNeighbour, 1.0 / kNeighbour}) {
                const core::Range range = problem.allowed(found.causes, k);
                guesses.push_back({found.causes, x, 0.0});
                guesses.back().x[k] = std::clamp(factor * x[k], range.low, range.high);
            }
    for (Fit& again : fits_of(problem, guesses, jobs))
        if (again.log_evidence > found.log_evidence) found = std::move(again);
    return found;
}

std::vector<Guess> sides_apart(const Problem& problem, const Fit& base) {
    const auto build = static_cast<Eigen::Index>(problem.build().size());
    HeldSlopes held{base.jacobian.leftCols(build), base.x.head(build)};
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
        if (before - apart.cost > kOtherSideOdds) guesses.push_back(std::move(apart));  // half of what it has to be worth
    }
    return guesses;
}

namespace {

/// The place of the build parameter that is most beyond its tolerance among those whose cause may join; -1: none is.
Eigen::Index most_strained(const Problem& problem, const Fit& base) {
    Eigen::Index most = -1;
    for (std::size_t k = 0; k < problem.build().size(); ++k) {
        const BuildParameter& own = problem.build()[k];
        const auto i = static_cast<Eigen::Index>(k);
        const double least = most < 0 ? kMisstated : std::abs(base.x[most]);
        if (own.cause.id.empty() || !own.stated || std::abs(base.x[i]) <= least) continue;
        if (!causes_beside({own.cause}, base.causes).empty()) most = i;
    }
    return most;
}

/// The same figure on the other side, as far off in the same direction; -1: there is none.
Eigen::Index counterpart(const Problem& problem, const Fit& base, Eigen::Index of) {
    const Cause& cause = problem.build()[static_cast<std::size_t>(of)].cause;
    for (std::size_t k = 0; k < problem.build().size(); ++k)
        if (const auto i = static_cast<Eigen::Index>(k);
            i != of && problem.build()[k].cause.id == cause.id && base.x[i] / base.x[of] > kLikeStrain)
            return i;
    return -1;
}

}  // namespace

std::optional<Guess> restated(const Problem& problem, const Fit& base) {
    const Eigen::Index most = most_strained(problem, base);
    if (most < 0 || base.causes.size() >= kMostEffects) return std::nullopt;
    const auto size_of = [&](Eigen::Index k) {
        const BuildParameter& own = problem.build()[static_cast<std::size_t>(k)];
        return base.x[k] * own.sigma * own.cause_size;
    };
    Cause cause = problem.build()[static_cast<std::size_t>(most)].cause;
    double size = size_of(most);
    Eigen::VectorXd x = base.x;
    x[most] = 0.0;
    const Eigen::Index other = counterpart(problem, base, most);
    if (Cause both{cause.id, "both"}; other >= 0 && !causes_beside({both}, base.causes).empty()) {
        cause = both;
        size = 0.5 * (size + size_of(other));
        x[other] = 0.0;
    }
    Guess guess{base.causes, {}, 0.0};
    guess.causes.push_back(cause);
    const int place = problem.effect_size_index(guess.causes, base.causes.size());
    guess.x = problem.start(guess.causes);
    guess.x.head(place) = x;
    const core::Range range = problem.allowed(guess.causes, place);
    guess.x[place] = std::clamp(size / problem.effect(cause.id).parameters.front().scale, range.low, range.high);
    return guess;
}

Fit searched_again(const Problem& problem, Fit found, unsigned jobs) {
    for (std::size_t c = found.causes.size(); c-- > 0 && !explained(problem, found);) {
        const Guess guess = guess_upon(problem, without(problem, found, c), found.causes[c]);
        Fit again = fit(problem, guess.causes, guess.x, {.jobs = jobs});
        if (again.log_evidence > found.log_evidence) found = std::move(again);
    }
    return found;
}

Eigen::MatrixXd joined(const Eigen::MatrixXd& first, const Eigen::MatrixXd& others) {
    Eigen::MatrixXd all(first.rows(), first.cols() + others.cols());
    all << first, others;
    return all;
}

Guess descend(const Problem& problem, const Eigen::VectorXd& spread, HeldSlopes& held, Guess start, const DescendOptions& options,
              const std::vector<bool>* kept) {
    const auto seen = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
        return problem.thin_residual(start.causes, x).cwiseQuotient(spread);
    };
    Eigen::VectorXd residual;
    Eigen::MatrixXd own = problem.slopes(start.causes, start.x, held.at.size(), start.x.size(), 1, &residual);
    residual = residual.cwiseQuotient(spread);
    start.cost = cost_of(problem, start.causes, residual, start.x, kept);
    if (!std::isfinite(start.cost)) return start;  // a rig that runs away, as with a negative spring at the joint
    for (int i = 0; i < options.steps; ++i) {
        problem.renew(held, start.causes, start.x);
        if (i > 0) own = problem.slopes(start.causes, start.x, held.at.size(), start.x.size());
        const Eigen::MatrixXd all = joined(held.slopes, own);
        const Eigen::VectorXd step =
            linear_step(problem, start.causes, start.x, residual, spread.cwiseInverse().asDiagonal() * all, kept) - start.x;
        if (!step.allFinite()) break;
        const double before = start.cost;
        for (double share = 1.0; share >= options.smallest && start.cost == before; share *= 0.4) {
            const Eigen::VectorXd x = start.x + share * step, left = seen(x);
            const double cost = cost_of(problem, start.causes, left, x, kept);
            if (!(cost < before)) continue;
            start.x = x;
            start.cost = cost;
            residual = left;
        }
        if (before - start.cost <= options.least) break;
    }
    return start;
}

}  // namespace fusee::inference
