#include "fusee/inference/search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "fusee/inference/screen.h"
#include "fusee/inference/splits.h"
#include "ranking.h"
#include "refine.h"

namespace fusee::inference {

namespace {

/// Hypotheses that the model can simulate.
std::vector<Fit> simulated(std::vector<Fit> fits) {
    std::erase_if(fits, [](const Fit& fit) { return !std::isfinite(fit.log_evidence); });
    return fits;
}
std::vector<Guess> simulated(std::vector<Guess> guesses) {
    std::erase_if(guesses, [](const Guess& guess) { return !std::isfinite(guess.cost); });
    return guesses;
}

void append(std::vector<Fit>& fits, std::vector<Fit> more) {
    more = simulated(std::move(more));
    std::move(more.begin(), more.end(), std::back_inserter(fits));
}

/// The guesses whose causes no fit has yet.
std::vector<Guess> unknown_to(const std::vector<Fit>& fits, std::vector<Guess> guesses) {
    std::erase_if(guesses, [&](const Guess& guess) {
        return std::any_of(fits.begin(), fits.end(), [&](const Fit& known) { return same_causes(known.causes, guess.causes); });
    });
    return guesses;
}

/// Full fits of the best guesses that are new, and of one more if direct rows favour it by the odds of an effect: in a simulation a
/// friction may look worse than none until all other parameters follow it, since what sticks there slips elsewhere.
void add_best(const Problem& problem, std::vector<Guess> guesses, const SearchOptions& options, std::vector<Fit>& fits) {
    guesses = unknown_to(fits, simulated(std::move(guesses)));
    if (guesses.size() > kPairs) {
        const std::vector<double> costs = direct_costs(problem, guesses, options.jobs);
        const auto others = costs.begin() + kPairs, least = std::min_element(others, costs.end());
        const bool favoured = *least + kSecondOdds < *std::min_element(costs.begin(), others);
        std::swap(guesses[kPairs], guesses[static_cast<std::size_t>(least - costs.begin())]);
        guesses.resize(kPairs + (favoured ? 1 : 0));
    }
    append(fits, fits_of(problem, guesses, options.jobs));
}

/// Fits with one effect more than `bases`, the best first: the best guesses upon each, and sides with sizes of their own.
void add_upon(const Problem& problem, const std::vector<Cause>& causes, std::span<const Fit> bases, const SearchOptions& options,
              std::vector<Fit>& fits) {
    for (const Fit& base : bases) {
        add_best(problem, screen(problem, base, causes_beside(causes, base.causes), options.jobs), options, fits);
        add_best(problem, sides_apart(problem, base), options, fits);
    }
}

/// The first of `fits`, which are sorted, without those that are too far behind.
std::vector<Fit> bases_of(const Problem& problem, const std::vector<Fit>& fits, std::size_t effects) {
    std::vector<Fit> bases;
    for (const Fit& fit : fits)
        if (fit.causes.size() == effects && bases.size() < kBases &&
            (bases.empty() || score(problem, fit) >= score(problem, bases.front()) - kWorthAPair))
            bases.push_back(fit);
    return bases;
}

/// Pairs of the single ones with each other: two great effects hide each other, so that each alone may be far from the best.
void add_pairs_of_singles(const Problem& problem, const std::vector<Fit>& singles, const SearchOptions& options, std::vector<Fit>& fits) {
    std::vector<Cause> causes;
    for (const Fit& single : singles) causes.push_back(single.causes.front());
    std::vector<Guess> guesses;
    for (const Fit& base : singles)
        for (Guess& guess : screen(problem, base, causes_beside(causes, base.causes), options.jobs)) guesses.push_back(std::move(guess));
    std::stable_sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) { return a.cost < b.cost; });
    std::vector<Guess> different;
    for (Guess& guess : guesses)
        if (std::none_of(different.begin(), different.end(), [&](const Guess& d) { return same_causes(d.causes, guess.causes); }))
            different.push_back(std::move(guess));
    add_best(problem, std::move(different), options, fits);
}

/// Does a hypothesis that stands explain all?
bool any_explains(const Problem& problem, const std::vector<Fit>& fits) {
    return std::any_of(fits.begin(), fits.end(), [&](const Fit& fit) { return sizes_stand(problem, fit) && explained(problem, fit); });
}

/// The best hypotheses that do not explain all are searched again: a fit in a local minimum may be strained, and would be left out.
void search_again(const Problem& problem, const SearchOptions& options, std::vector<Fit>& fits) {
    sort_by_score(problem, fits);
    for (std::size_t i = 0; i < std::min(kRefined, fits.size()); ++i)
        if (!fits[i].causes.empty() && !explained(problem, fits[i]))
            fits[i] = searched_again(problem, relaxed(problem, std::move(fits[i]), options.jobs), options.jobs);
}

/// Adds to `fits`, and sorts them: the best, and no effect, with what their strained build parameters are as causes, one after the other.
void add_restated(const Problem& problem, const SearchOptions& options, std::vector<Fit>& fits) {
    sort_by_score(problem, fits);
    std::vector<Fit> bases;
    for (std::size_t i = 0; i < fits.size(); ++i)
        if (i < kRefined || fits[i].causes.empty()) bases.push_back(fits[i]);
    for (Fit& base : bases)
        for (std::optional<Guess> guess = restated(problem, base); guess; guess = restated(problem, base)) {
            const double before = score(problem, base);
            const auto known =
                std::find_if(fits.begin(), fits.end(), [&](const Fit& own) { return same_causes(own.causes, guess->causes); });
            base = known != fits.end() ? *known : fit(problem, guess->causes, guess->x, {.jobs = options.jobs});
            if (!std::isfinite(base.log_evidence)) break;
            if (known == fits.end()) fits.push_back(base);
            if (score(problem, base) <= before) break;
        }
    sort_by_score(problem, fits);
}

/// Cost of the rows that the refits of `fit` have not seen.
double held_out_cost(const Problem& problem, const Fit& null, const Fit& fit, unsigned jobs) {
    return cost_of(problem, {}, held_out(problem, null, fit, jobs).residual, problem.start({}));
}

/// A third and a fourth effect upon the best hypotheses, as long as nothing explains all, the evidence pays for the odds of one effect
/// more, and rows that a fit has not seen are predicted better.
void add_more(const Problem& problem, const Fit& null, const std::vector<Cause>& causes, const SearchOptions& options,
              std::vector<Fit>& fits) {
    for (std::size_t effects = 2; !any_explains(problem, fits); ++effects) {
        add_restated(problem, options, fits);
        sort_by_score(problem, fits);
        const Fit best = fits.front();
        if (best.causes.size() < effects || best.causes.size() == kMostEffects) return;
        if (best.causes.size() > effects) continue;  // restated
        std::vector<Fit> more = fits;
        add_upon(problem, causes, bases_of(problem, fits, effects), options, more);
        more.erase(more.begin(), more.begin() + static_cast<std::ptrdiff_t>(fits.size()));
        if (more.empty()) return;
        sort_by_score(problem, more);
        more.front() = searched_again(problem, relaxed(problem, std::move(more.front()), options.jobs), options.jobs);
        if (score(problem, more.front()) <= score(problem, best)) return;
        if (held_out_cost(problem, null, more.front(), options.jobs) >= held_out_cost(problem, null, best, options.jobs)) return;
        append(fits, std::move(more));
    }
}

const Fit& best_of(const Problem& problem, const std::vector<Fit>& fits) {
    return *std::max_element(fits.begin(), fits.end(), [&](const Fit& a, const Fit& b) { return score(problem, a) < score(problem, b); });
}

/// The best hypothesis without one of its effects, started at it: a smaller one that stopped elsewhere would make the effect look
/// necessary. Of three effects and more each is also exchanged for another: one may have a neighbour's name, found before the others were.
void step_back(const Problem& problem, const std::vector<Cause>& causes, const SearchOptions& options, std::vector<Fit>& fits) {
    const Fit best = best_of(problem, fits);
    if (best.causes.size() < 2) return;
    for (std::size_t c = best.causes.size(); c-- > 0;) {
        Fit smaller = refit_without(problem, best, c, options.jobs);
        if (score(problem, best) - score(problem, smaller) < kWorthARestart) smaller = restarted(problem, std::move(smaller), options.jobs);
        if (best.causes.size() > 2)
            add_best(problem, screen(problem, smaller, causes_beside(causes, smaller.causes), options.jobs), options, fits);
        const auto known =
            std::find_if(fits.begin(), fits.end(), [&](const Fit& other) { return same_causes(other.causes, smaller.causes); });
        if (known == fits.end())
            append(fits, {std::move(smaller)});
        else if (score(problem, smaller) > score(problem, *known))
            *known = std::move(smaller);
    }
    const Fit& found = best_of(problem, fits);
    if (found.causes.size() > 2 && !same_causes(found.causes, best.causes)) step_back(problem, causes, options, fits);
}

/// The best hypothesis with a size for each side in the place of one for both, which may stand on build parameters within tolerance.
void add_sides_apart(const Problem& problem, const SearchOptions& options, std::vector<Fit>& fits) {
    add_best(problem, sides_apart(problem, best_of(problem, fits)), options, fits);
}

/// The best single effects, best first. If one explains all, only those close to it in the screening are rivals.
std::vector<Fit> singles_of(const Problem& problem, const Fit& null, std::vector<Guess> guesses, const SearchOptions& options) {
    guesses = simulated(std::move(guesses));
    if (guesses.empty()) return {};
    std::vector<Fit> singles = fits_of(problem, std::span(guesses).first(1), options.jobs);
    const double enough = singles.front().cost + kNearEnough * (null.cost - singles.front().cost);
    std::vector<Guess> rivals(guesses.begin() + 1, guesses.begin() + static_cast<std::ptrdiff_t>(std::min(kSingles, guesses.size())));
    if (explained(problem, singles.front())) std::erase_if(rivals, [&](const Guess& guess) { return guess.cost >= enough; });
    append(singles, fits_of(problem, rivals, options.jobs));
    singles = simulated(std::move(singles));
    sort_by_score(problem, singles);
    return singles;
}

/// The model as stated, in the place of a fit.
Fit as_stated(const Problem& problem, unsigned jobs) {
    Fit stated;
    stated.x = problem.start({});
    stated.residual = problem.residual({}, stated.x);
    stated.spread = spread_of(problem, {}, stated.x, jobs);
    stated.jacobian = problem.slopes({}, stated.x, 0, stated.x.size());
    return stated;
}

/// Single effects upon the build tolerances. A simulator has few figures, which may lie far from what was stated in the fit without the
/// right effect, where slopes lead astray: each effect is then also tried upon the model as stated. Of both the better half is tried
/// further: the right one is nearly always the first of one.
std::vector<Guess> screened_singles(const Problem& problem, const Fit& null, const std::vector<Cause>& causes, unsigned jobs) {
    const bool astray = problem.has_figures() && std::abs(worst_nuisance_pull(problem, null).sigmas) > kStrained;
    const std::size_t tried = astray ? (causes.size() + 1) / 2 : causes.size();
    std::vector<Guess> guesses = screen(problem, null, causes, jobs, tried);
    if (!astray) return guesses;
    for (Guess& other : screen(problem, as_stated(problem, jobs), causes, jobs, tried)) {
        const auto same = std::find_if(guesses.begin(), guesses.end(), [&](const Guess& guess) { return guess.causes == other.causes; });
        if (same == guesses.end())
            guesses.push_back(std::move(other));
        else if (other.cost < same->cost)
            *same = std::move(other);
    }
    sort_by_cost(guesses);
    return guesses;
}

/// What speaks against no effect: a build parameter beyond what its tolerance allows, where its figure may be named.
double strain(const Problem& problem, const Fit& null) {
    const WorstNuisancePull most = worst_nuisance_pull(problem, null);
    const bool has_cause = !problem.build().empty() && !problem.build()[most.parameter].cause.id.empty();
    return has_cause && std::abs(most.sigmas) > kMisstated ? kMisstatedOdds : 0.0;
}

}  // namespace

Search search(const Problem& problem, const SearchOptions& options) {
    const std::vector<Cause> causes = possible_causes(problem);
    const auto tell = [&](const char* what) {
        if (options.progress) options.progress(what);
    };
    Fit null = fit(problem, {}, problem.start({}), {.jobs = options.jobs});
    null.log_evidence -= strain(problem, null);
    tell("build tolerances");
    const std::vector<Guess> guesses = screened_singles(problem, null, causes, options.jobs);
    tell("screening of single effects");
    std::vector<Fit> fits{null};
    append(fits, singles_of(problem, null, guesses, options));
    add_restated(problem, options, fits);
    std::vector<Fit> singles = fits;
    std::erase_if(singles, [](const Fit& own) { return own.causes.size() != 1; });
    tell("single effects");
    const bool found = !singles.empty() && score(problem, singles.front()) > score(problem, null);
    if (found && !explained(problem, singles.front())) {
        singles.front() = restarted(problem, std::move(singles.front()), options.jobs);
        *std::find_if(fits.begin(), fits.end(), [](const Fit& own) { return own.causes.size() == 1; }) = singles.front();
    }
    if (found && !explained(problem, singles.front())) {
        add_upon(problem, causes, bases_of(problem, singles, 1), options, fits);
        if (!any_explains(problem, fits)) add_pairs_of_singles(problem, singles, options, fits);
    }
    if (!any_explains(problem, fits)) search_again(problem, options, fits);
    add_more(problem, null, causes, options, fits);
    step_back(problem, causes, options, fits);
    add_sides_apart(problem, options, fits);
    tell("sets of effects");
    Search result = ranked(problem, std::move(fits), options);
    tell("experiments left out");
    return result;
}

}  // namespace fusee::inference
