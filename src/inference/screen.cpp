#include "fusee/inference/screen.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "fusee/core/parallel.h"
#include "fusee/core/units.h"
#include "refine.h"

namespace fusee::inference {

namespace {

using Starts = std::vector<Eigen::VectorXd>;

/// Every one of these sizes with every try of the further parameters.
Starts grid_of(const Effect& effect, const std::vector<double>& sizes, Eigen::Index size_at, Eigen::VectorXd first) {
    Starts all;
    for (const double size : sizes) {
        first[size_at] = size;
        all.push_back(first);
    }
    for (std::size_t k = 1; k < effect.parameters.size(); ++k) {
        const EffectParameter& p = effect.parameters[k];
        if (p.tries.empty()) continue;
        Starts more;
        for (const Eigen::VectorXd& x : all)
            for (const double value : p.tries) {
                more.push_back(x);
                more.back()[size_at + static_cast<Eigen::Index>(k)] = value / p.scale;
            }
        all = std::move(more);
    }
    return all;
}

/// Ripples upon a fit. A ripple acts nearly in proportion to its amplitude, so that of each count two predictions are enough: its sine
/// and its cosine.
class RippleScan {
public:
    RippleScan(const Problem& problem, const Fit& base, const Causes& causes, const std::vector<bool>* kept)
        : problem_(problem), base_(base), causes_(causes), kept_(kept), effect_(problem.effect(causes.back().id)), size_at_(base.x.size()) {
        held_ = base.spread.cwiseInverse().asDiagonal() * base.jacobian;
        residual_ = problem.thin_residual(base.causes, base.x).cwiseQuotient(base.spread);
    }
    /// The counts that fit best in the linear model, with amplitude and phase. `first`: x with anything at the place of the ripple.
    [[nodiscard]] Starts best(const Eigen::VectorXd& first) const {
        const EffectParameter& counts = effect_.parameters[1];
        std::vector<Eigen::VectorXd> places;  // of each count the sine and the cosine, at the first start of the size
        for (const double count : counts.tries)
            for (const double phase : {0.0, 0.5 * core::kPi}) {
                places.push_back(first);
                places.back().segment(size_at_, 3) << effect_.starts.front(), count / counts.scale, phase / effect_.parameters[2].scale;
            }
        const std::vector<Eigen::VectorXd> seen = problem_.thin_residuals(causes_, places);
        std::vector<Guess> guesses;
        for (std::size_t i = 0; i < seen.size(); i += 2) guesses.push_back(at(places[i], column(seen[i]), column(seen[i + 1])));
        std::stable_sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) { return a.cost < b.cost; });
        Starts starts;
        for (std::size_t i = 0; i < std::min(kRippleStarts, guesses.size()); ++i) starts.push_back(guesses[i].x);
        return starts;
    }

private:
    /// d residual/d amplitude, from what the first start of the size leaves.
    [[nodiscard]] Eigen::VectorXd column(const Eigen::VectorXd& seen) const {
        return (seen.cwiseQuotient(base_.spread) - residual_) / effect_.starts.front();
    }
    /// Amplitude and phase at the count of x, in the linear model.
    [[nodiscard]] Guess at(Eigen::VectorXd x, const Eigen::VectorXd& of_sine, const Eigen::VectorXd& of_cosine) const {
        const double count = x[size_at_ + 1];
        Eigen::MatrixXd own = Eigen::MatrixXd::Zero(residual_.size(), 3);  // the amplitude of the cosine in the place of the phase
        own.col(0) = of_sine;
        own.col(2) = of_cosine;
        x[size_at_] = x[size_at_ + 2] = 0.0;
        const Eigen::MatrixXd jacobian = joined(held_, own);
        const Eigen::VectorXd next = linear_step(problem_, causes_, x, residual_, jacobian, kept_);
        const double sine = next[size_at_], cosine = next[size_at_ + 2];
        Guess guess{causes_, next, 1e300};
        guess.x[size_at_] = std::hypot(sine, cosine);
        guess.x[size_at_ + 1] = count;
        guess.x[size_at_ + 2] = std::atan2(cosine, sine) / effect_.parameters[2].scale;
        const double cost = cost_of(problem_, causes_, residual_ + jacobian * (next - x), guess.x, kept_);
        if (std::isfinite(cost)) guess.cost = cost;
        guess.x.head(size_at_) = base_.x;
        return guess;
    }
    const Problem& problem_;
    const Fit& base_;
    const Causes& causes_;
    const std::vector<bool>* kept_;
    const Effect& effect_;
    Eigen::Index size_at_;
    Eigen::MatrixXd held_;
    Eigen::VectorXd residual_;
};

void add_like_the_other_side(const Problem& problem, const Fit& base, const Causes& causes, Starts& starts) {
    const Eigen::Index own = starts.front().size() - base.x.size();
    for (std::size_t c = 0; c < base.causes.size(); ++c) {
        if (base.causes[c].id != causes.back().id) continue;
        starts.push_back(starts.front());
        starts.back().tail(own) = base.x.segment(problem.effect_size_index(base.causes, c), own);
    }
}

/// The same starts with deviating build parameters back at 0: the effect replaces them now. Stick-slip friction
/// gives a fit no slope in that direction.
void add_relaxed(const Problem& problem, Starts& starts) {
    const auto build = static_cast<Eigen::Index>(problem.build().size());
    Eigen::ArrayXd free = starts.front().head(build).array();
    free = (free.abs() > kStrained).select(0.0, free);
    if ((free == starts.front().head(build).array()).all()) return;
    for (std::size_t i = 0, n = starts.size(); i < n; ++i) {
        starts.push_back(starts[i]);
        starts.back().head(build) = free;
    }
}

/// x at which a fit of the last of `causes` upon `base` may start: the x of `base` with every start of the size and every try of the
/// further parameters. Of a ripple instead the best counts with amplitude and phase in the linear model, fitted to the rows `kept`.
/// Where `base` has the same cause on the other side, its figures are a start too: the two sides are of one design.
/// @return not empty
std::vector<Eigen::VectorXd> starts_upon(const Problem& problem, const Fit& base, const Causes& causes, const std::vector<bool>* kept) {
    const Effect& effect = problem.effect(causes.back().id);
    Eigen::VectorXd first = problem.start(causes);
    first.head(base.x.size()) = base.x;
    Starts starts = effect.has_phase() ? RippleScan(problem, base, causes, kept).best(first)
                                       : grid_of(effect, effect.starts, base.x.size(), std::move(first));
    add_like_the_other_side(problem, base, causes, starts);
    add_relaxed(problem, starts);
    return starts;
}

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
    Eigen::MatrixXd slopes = joined(base.jacobian, Eigen::MatrixXd(residual.size(), x.size() - first));
    for (int round = 0; round < kDirectRounds; ++round) {
        for (int k = first; k < slopes.cols(); ++k) {
            Eigen::VectorXd near = x;
            near[k] += kDirectStep;
            slopes.col(k) = (problem.direct_residual(causes, near) - residual) / kDirectStep;
        }
        const Eigen::VectorXd next = linear_step(problem, causes, x, residual, slopes, &direct);
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

/// A step with the secant from no effect to the size of a start, where the figures need not follow a size that is only tried: slopes that
/// were taken at `base` hold there. @param residual at the start, over the spread
Guess along_secant(const Problem& problem, const Fit& base, Guess start, const Eigen::VectorXd& residual, Eigen::MatrixXd slopes,
                   const std::vector<bool>* kept) {
    const Eigen::Index size_at = base.x.size();
    const double size = start.x[size_at];
    start.cost = 1e300;
    if (size == 0.0) return start;
    slopes.col(size_at) = (residual - problem.thin_residual(base.causes, base.x).cwiseQuotient(base.spread)) / size;
    const Eigen::VectorXd next = linear_step(problem, start.causes, start.x, residual, slopes, kept);
    if (!next.allFinite()) return start;
    start.x = next;
    const double cost = cost_of(problem, start.causes, problem.thin_residual(start.causes, next).cwiseQuotient(base.spread), next, kept);
    if (std::isfinite(cost)) start.cost = cost;
    return start;
}

/// Starts of a limit from the size at which it begins to change a value of a run to the first of its sizes that does; none if its first
/// size does or none does. A limit that the runs do not reach gives a fit no slope, and one far below what they reach is worse than none.
Starts reaching_starts(const Problem& problem, const Fit& base, const Causes& causes, Eigen::VectorXd x) {
    const Effect& effect = problem.effect(causes.back().id);
    if (effect.far.empty()) return {};
    const Eigen::VectorXd held = problem.thin_residual(base.causes, base.x);
    x.head(base.x.size()) = base.x;
    const auto changes = [&](double size) {
        x[base.x.size()] = size;
        return !((problem.thin_residual(causes, x) - held).cwiseAbs().maxCoeff() < kDead);
    };
    std::vector<double> sizes = effect.starts;
    sizes.insert(sizes.end(), effect.far.begin(), effect.far.end());
    const auto first = std::find_if(sizes.begin(), sizes.end(), changes);
    if (first == sizes.begin() || first == sizes.end()) return {};
    double dead = *std::prev(first), alive = *first;
    for (int i = 0; i < kReaching; ++i) {
        const double middle = 0.5 * (dead + alive);
        (changes(middle) ? alive : dead) = middle;
    }
    std::vector<double> between;
    for (int k = 1; k < kReaching; ++k) between.push_back(alive + (*first - alive) * k / kReaching);
    return grid_of(effect, between, base.x.size(), x);
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
    const Starts reaching = reaching_starts(problem, base, causes, best.x);
    starts.insert(starts.end(), reaching.begin(), reaching.end());
    const std::vector<Eigen::VectorXd> seen_at = problem.thin_residuals(causes, starts);
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const Eigen::VectorXd& x = starts[i];
        const Eigen::VectorXd residual = seen_at[i].cwiseQuotient(base.spread);
        Eigen::VectorXd next = linear_step(problem, causes, x, residual, held, kept);
        next.tail(own) = x.tail(own);
        const double cost = cost_of(problem, causes, residual + held * (next - x), next, kept);
        if (cost < best.cost) best = {causes, next, cost};
        if (problem.has_figures() && x.head(base.x.size()) == base.x)
            if (Guess other = along_secant(problem, base, {causes, x, cost}, residual, held, kept); other.cost < best.cost)
                best = std::move(other);
    }
    return best;
}

/// A few steps with the columns of the effect.
Guess improved(const Problem& problem, const Fit& base, Guess guess, const std::vector<bool>* kept) {
    HeldSlopes held{base.jacobian, base.x};
    return descend(problem, base.spread, held, std::move(guess), {.steps = kScreenRounds, .least = 0.0, .smallest = 0.2}, kept);
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

std::vector<double> direct_costs(const Problem& problem, const std::vector<Guess>& guesses, unsigned jobs) {
    const std::vector<bool> direct = direct_rows(problem, nullptr);
    std::vector<double> costs(guesses.size(), 0.0);
    if (std::find(direct.begin(), direct.end(), true) == direct.end()) return costs;
    core::parallel_for(guesses.size(), jobs, [&](std::size_t i) {
        const Guess& own = guesses[i];
        costs[i] = cost_of(problem, own.causes, problem.direct_residual(own.causes, own.x), own.x, &direct);
    });
    return costs;
}

std::vector<Fit> fits_of(const Problem& problem, std::span<const Guess> guesses, unsigned jobs) {
    std::vector<Fit> fits(guesses.size());
    const unsigned jobs_of_one = std::max(1U, jobs / std::max(1U, static_cast<unsigned>(guesses.size())));
    core::parallel_for(guesses.size(), jobs,
                       [&](std::size_t i) { fits[i] = fit(problem, guesses[i].causes, guesses[i].x, {.jobs = jobs_of_one}); });
    return fits;
}

}  // namespace fusee::inference
