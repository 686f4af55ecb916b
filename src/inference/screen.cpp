#include "fusee/inference/screen.h"

#include <algorithm>
#include <cmath>

#include "descend.h"
#include "fusee/core/parallel.h"
#include "starts.h"

namespace fusee::inference {

namespace {

/// The rows of direct experiments, of those `kept`.
std::vector<bool> direct_rows(const Problem& problem, const std::vector<bool>* kept) {
    std::vector<bool> direct(static_cast<std::size_t>(problem.residual_count()));
    for (std::size_t i = 0; i < direct.size(); ++i)
        direct[i] = problem.experiments()[problem.experiment_of(static_cast<int>(i))].direct && (kept == nullptr || (*kept)[i]);
    return direct;
}

/// x fitted to the rows `direct`, which need no simulation: a far better start where they see the effect.
Eigen::VectorXd directed(const Problem& problem, const Fit& base, const Causes& causes, const std::vector<bool>& direct,
                         Eigen::VectorXd x) {
    const auto first = static_cast<int>(base.x.size());
    Eigen::VectorXd residual = problem.direct_residual(causes, x);
    double cost = cost_of(problem, causes, residual, x, &direct);
    for (int round = 0; round < kDirectRounds; ++round) {
        Eigen::MatrixXd columns(residual.size(), x.size() - first);
        for (int k = 0; k < columns.cols(); ++k) {
            Eigen::VectorXd near = x;
            near[first + k] += kDirectStep;
            columns.col(k) = (problem.direct_residual(causes, near) - residual) / kDirectStep;
        }
        const Eigen::VectorXd next = linear_step(problem, causes, x, residual, joined(base.jacobian, columns), &direct);
        if (!next.allFinite()) break;
        const Eigen::VectorXd left = problem.direct_residual(causes, next);
        const double now = cost_of(problem, causes, left, next, &direct);
        if (!(now < cost)) break;
        x = next;
        residual = left;
        cost = now;
    }
    return x;
}

/// Starts that end at the same place count once.
void drop_like(std::vector<Eigen::VectorXd>& starts) {
    std::vector<Eigen::VectorXd> kept;
    for (const Eigen::VectorXd& x : starts)
        if (std::none_of(kept.begin(), kept.end(), [&](const Eigen::VectorXd& other) { return (other - x).cwiseAbs().maxCoeff() < kLike; }))
            kept.push_back(x);
    starts = std::move(kept);
}

/// `cause` upon `base` from the best of its starts.
Guess best_start(const Problem& problem, const Fit& base, const Cause& cause, const std::vector<bool>* kept) {
    const Effect& effect = problem.effect(cause.id);
    Causes causes = base.causes;
    causes.push_back(cause);
    Guess best{causes, {}, 1e300};
    const auto own = static_cast<Eigen::Index>(problem.dimension(causes)) - base.x.size();
    const Eigen::MatrixXd held =
        joined(base.spread.cwiseInverse().asDiagonal() * base.jacobian, Eigen::MatrixXd::Zero(base.jacobian.rows(), own));
    std::vector<Eigen::VectorXd> starts = starts_upon(problem, base, causes, kept);
    const std::vector<bool> direct = direct_rows(problem, kept);
    const bool seen = std::any_of(effect.seen_by.begin(), effect.seen_by.end(), [&](std::size_t e) {
        for (std::size_t i = 0; i < direct.size(); ++i)
            if (direct[i] && problem.experiment_of(static_cast<int>(i)) == e) return true;
        return false;
    });
    if (seen) {
        for (Eigen::VectorXd& x : starts) x = directed(problem, base, causes, direct, x);
        drop_like(starts);
    }
    best.x = starts.front();
    const std::vector<Eigen::VectorXd> seen_at = problem.thin_residuals(causes, starts);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const Eigen::VectorXd& x = starts[i];
        const Eigen::VectorXd residual = seen_at[i].cwiseQuotient(base.spread);
        Eigen::VectorXd next = linear_step(problem, causes, x, residual, held, kept);
        next.tail(own) = x.tail(own);
        const double cost = cost_of(problem, causes, residual + held * (next - x), next, kept);
        if (cost < best.cost) best = {causes, next, cost};
    }
    return best;
}

/// A few steps with the columns of the effect.
Guess improved(const Problem& problem, const Fit& base, Guess guess, const std::vector<bool>* kept) {
    return descend(problem, base.spread, problem.held(base.jacobian), std::move(guess),
                   {.steps = kScreenRounds, .least = 0.0, .smallest = 0.2}, kept);
}

}  // namespace

void sort_by_cost(std::vector<Guess>& guesses) {
    std::stable_sort(guesses.begin(), guesses.end(),
                     [](const Guess& a, const Guess& b) { return a.cost < b.cost || (std::isfinite(a.cost) && !std::isfinite(b.cost)); });
}

std::vector<Cause> causes_of(const Model& model, bool generic) {
    std::vector<Cause> causes;
    for (const Effect& effect : model.effects())
        for (const std::string& side : effect.sides)
            if (effect.generic == generic) causes.push_back({effect.id, side});
    return causes;
}

std::vector<Cause> possible_causes(const Problem& problem, bool generic) {
    std::vector<Cause> causes = causes_of(problem.model(), generic);
    std::erase_if(causes, [&](const Cause& cause) {
        const std::vector<std::size_t>& seen_by = problem.effect(cause.id).seen_by;
        return std::none_of(seen_by.begin(), seen_by.end(), [&](std::size_t e) { return problem.experiments()[e].rows > 0; });
    });
    return causes;
}

std::vector<Cause> causes_beside(std::vector<Cause> causes, const Causes& base) {
    std::erase_if(causes, [&](const Cause& cause) {
        return std::any_of(base.begin(), base.end(), [&](const Cause& there) {
            return there == cause || (there.id == cause.id && (there.side == "both" || cause.side == "both"));
        });
    });
    return causes;
}

bool same_causes(const Causes& a, const Causes& b) { return a.size() == b.size() && std::is_permutation(a.begin(), a.end(), b.begin()); }

Fit without(const Problem& problem, const Fit& fit, std::size_t c) {
    const int from = problem.effect_size_index(fit.causes, c), to = problem.effect_size_index(fit.causes, c + 1),
              left = static_cast<int>(fit.x.size()) - to;
    Fit base = fit;
    base.causes.erase(base.causes.begin() + static_cast<std::ptrdiff_t>(c));
    base.x = problem.without(fit.causes, fit.x, c);
    base.jacobian = joined(fit.jacobian.leftCols(from), fit.jacobian.rightCols(left));
    return base;
}

Fit refit_without(const Problem& problem, const Fit& of, std::size_t c, unsigned jobs) {
    Causes kept = of.causes;
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(c));
    return fit(problem, kept, problem.without(of.causes, of.x, c), {.jobs = jobs});
}

Guess guess_upon(const Problem& problem, const Fit& base, const Cause& cause, const std::vector<bool>* kept) {
    return improved(problem, base, best_start(problem, base, cause, kept), kept);
}

std::vector<Guess> screen(const Problem& problem, const Fit& base, const std::vector<Cause>& causes, unsigned jobs,
                          std::size_t improved_ones) {
    std::vector<Guess> guesses(causes.size());
    core::parallel_for(causes.size(), jobs, [&](std::size_t i) { guesses[i] = best_start(problem, base, causes[i], nullptr); });
    if (improved_ones < guesses.size()) {
        sort_by_cost(guesses);
        guesses.resize(improved_ones);
    }
    core::parallel_for(guesses.size(), jobs, [&](std::size_t i) { guesses[i] = improved(problem, base, std::move(guesses[i]), nullptr); });
    sort_by_cost(guesses);
    return guesses;
}

std::vector<Fit> fits_of(const Problem& problem, std::span<const Guess> guesses, unsigned jobs) {
    std::vector<Fit> fits(guesses.size());
    const unsigned jobs_of_one = std::max(1U, jobs / std::max(1U, static_cast<unsigned>(guesses.size())));
    core::parallel_for(guesses.size(), jobs,
                       [&](std::size_t i) { fits[i] = fit(problem, guesses[i].causes, guesses[i].x, {.jobs = jobs_of_one}); });
    return fits;
}

}  // namespace fusee::inference
