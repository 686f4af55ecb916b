#include "fusee/inference/search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "fusee/inference/interval.h"
#include "fusee/inference/screen.h"
#include "fusee/inference/splits.h"
#include "refine.h"

namespace fusee::inference {

namespace {

/// Is causes[c] the effect of an earlier one, on the other side and by another size?
bool is_other_side(const Problem& problem, const Fit& fit, std::size_t c) {
    const auto size = [&](std::size_t of) { return fit.x[problem.effect_size_index(fit.causes, of)]; };
    for (std::size_t b = 0; b < c; ++b)
        if (fit.causes[b].id == fit.causes[c].id)
            return std::abs(size(b) - size(c)) >= kUnequal * std::max(std::abs(size(b)), std::abs(size(c)));
    return false;
}

/// docs/theory/diagnosis.md, eq. 13 and 14. A build parameter that no workshop misses so far is a cause that the hypothesis does not name:
/// it costs as much as one.
double score(const Problem& problem, const Fit& fit) {
    const bool unnamed = !fit.causes.empty() && std::abs(worst_nuisance_pull(problem, fit).sigmas) > kImpossible;
    return fit.log_evidence - odds_against(problem, fit) - (unnamed ? kSecondOdds : 0.0);
}

void sort_by_score(const Problem& problem, std::vector<Fit>& fits) {
    std::stable_sort(fits.begin(), fits.end(), [&](const Fit& a, const Fit& b) { return score(problem, a) > score(problem, b); });
}

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

void add_best(const Problem& problem, std::vector<Guess> guesses, const SearchOptions& options, std::vector<Fit>& fits) {
    guesses = unknown_to(fits, simulated(std::move(guesses)));
    append(fits, fits_of(problem, std::span(guesses).first(std::min(kPairs, guesses.size())), options.jobs));
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

/// The best hypothesis without one of its effects, started at it: a smaller one that stopped elsewhere would make the effect look
/// necessary.
void step_back(const Problem& problem, const SearchOptions& options, std::vector<Fit>& fits) {
    const Fit best =
        *std::max_element(fits.begin(), fits.end(), [&](const Fit& a, const Fit& b) { return score(problem, a) < score(problem, b); });
    if (best.causes.size() < 2) return;
    for (std::size_t c = best.causes.size(); c-- > 0;) {
        Fit smaller = refit_without(problem, best, c, options.jobs);
        if (score(problem, best) - score(problem, smaller) < kWorthARestart) smaller = restarted(problem, std::move(smaller), options.jobs);
        const auto known =
            std::find_if(fits.begin(), fits.end(), [&](const Fit& other) { return same_causes(other.causes, smaller.causes); });
        if (known == fits.end())
            append(fits, {std::move(smaller)});
        else if (score(problem, smaller) > score(problem, *known))
            *known = std::move(smaller);
    }
}

/// The best hypothesis with a size for each side in the place of one for both, which may stand on build parameters within tolerance.
void add_sides_apart(const Problem& problem, const SearchOptions& options, std::vector<Fit>& fits) {
    sort_by_score(problem, fits);
    add_best(problem, sides_apart(problem, fits.front()), options, fits);
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

/// A hypothesis before ranking.
struct Ranked {
    Fit fit;
    double score = 0.0;
    Split left_out;  ///< empty until computed
};

void sort_by_score(std::vector<Ranked>& ranking) {
    std::stable_sort(ranking.begin(), ranking.end(), [](const Ranked& a, const Ranked& b) { return a.score > b.score; });
}

/// Applies the cost of a contradicted cause to the leading hypotheses until the leaders are all checked, no effect included.
void penalize_contradicted(const Problem& problem, std::vector<Ranked>& ranking, const SearchOptions& options) {
    const auto first = [&] { return ranking.begin() + static_cast<std::ptrdiff_t>(std::min(kLeftOut, ranking.size())); };
    // What is so far behind stays there even if the leader is contradicted.
    const double hopeless = kContradicted - std::log(kLeastAlternative);
    const auto unchecked = [&](const Ranked& h) { return h.left_out.x.empty() && h.score >= ranking.front().score - hopeless; };
    const auto is_null = [](const Ranked& h) { return h.fit.causes.empty(); };
    const Fit null = std::find_if(ranking.begin(), ranking.end(), is_null)->fit;
    const auto check = [&](Ranked& h) {
        h.left_out = experiments_left_out(problem, null, h.fit, options.jobs);
        if (!contradicted(problem, h.fit, h.left_out).empty()) h.score -= kContradicted;
    };
    check(*std::find_if(ranking.begin(), ranking.end(), is_null));
    for (auto next = std::find_if(ranking.begin(), first(), unchecked); next != first();
         next = std::find_if(ranking.begin(), first(), unchecked)) {
        check(*next);
        sort_by_score(ranking);
    }
}

/// Discounts as `discount_unfounded`, then sorts again.
void penalize_unfounded(std::vector<Ranked>& ranking) {
    std::vector<std::size_t> effects;
    std::vector<double> scores;
    for (const Ranked& h : ranking) {
        effects.push_back(h.fit.causes.size());
        scores.push_back(h.score);
    }
    discount_unfounded(effects, scores);
    for (std::size_t i = 0; i < ranking.size(); ++i) ranking[i].score = scores[i];
    sort_by_score(ranking);
}

Search with_probabilities(std::vector<Ranked> ranking) {
    Search result;
    for (Ranked& h : ranking) {
        if (h.fit.causes.empty()) result.null = result.fits.size();
        result.log_posterior.push_back(h.score - ranking.front().score);
        result.fits.push_back(std::move(h.fit));
        result.left_out.push_back(std::move(h.left_out));
    }
    result.probability = probabilities(result.log_posterior);
    return result;
}

Search ranked(const Problem& problem, std::vector<Fit> fits, const SearchOptions& options) {
    std::erase_if(fits, [&](const Fit& fit) { return !sizes_stand(problem, fit); });
    sort_by_score(problem, fits);
    std::vector<Ranked> ranking;
    for (Fit& fit : fits) {
        const double of_fit = score(problem, fit);
        ranking.push_back({std::move(fit), of_fit, {}});
    }
    penalize_contradicted(problem, ranking, options);
    penalize_unfounded(ranking);
    return with_probabilities(std::move(ranking));
}

}  // namespace

double odds_against(const Problem& problem, const Fit& fit) {
    double odds = 0.0;
    for (std::size_t c = 0; c < fit.causes.size(); ++c)
        odds += c == 0 ? kEffectOdds : is_other_side(problem, fit, c) ? kOtherSideOdds : kSecondOdds;
    return odds;
}

std::vector<double> probabilities(std::span<const double> log_scores) {
    const double most = *std::max_element(log_scores.begin(), log_scores.end());
    double sum = 0.0;
    std::vector<double> all;
    for (const double score : log_scores) sum += all.emplace_back(std::exp(score - most));
    for (double& p : all) p /= sum;
    return all;
}

bool rivalled(double best, double next) { return best < kSure && next >= kRival; }

void discount_unfounded(std::span<const std::size_t> effects, std::span<double> scores) {
    double none = -std::numeric_limits<double>::infinity(), one = none;
    for (std::size_t h = 0; h < scores.size(); ++h) {
        if (effects[h] == 0) none = std::max(none, scores[h]);
        if (effects[h] == 1) one = std::max(one, scores[h]);
    }
    for (std::size_t h = 0; h < scores.size() && one <= none; ++h)
        if (effects[h] > 1) scores[h] -= kContradicted;
}

Search with_fits(const Problem& problem, Search search, std::vector<Fit> fits, unsigned jobs) {
    if (fits.empty()) return search;
    const double best = score(problem, search.best());
    const Fit null = search.fits[search.null];
    std::vector<Ranked> ranking;
    for (std::size_t h = 0; h < search.fits.size(); ++h)
        ranking.push_back({std::move(search.fits[h]), search.log_posterior[h], std::move(search.left_out[h])});
    for (Fit& fit : simulated(std::move(fits))) {
        if (!sizes_stand(problem, fit)) continue;
        Ranked own{std::move(fit), 0.0, {}};
        own.score = score(problem, own.fit) - best;
        const auto known =
            std::find_if(ranking.begin(), ranking.end(), [&](const Ranked& h) { return same_causes(h.fit.causes, own.fit.causes); });
        if (known == ranking.end())
            ranking.push_back(std::move(own));
        else if (own.score > known->score)
            *known = std::move(own);
    }
    sort_by_score(ranking);
    if (Ranked& first = ranking.front(); first.left_out.x.empty()) first.left_out = experiments_left_out(problem, null, first.fit, jobs);
    return with_probabilities(std::move(ranking));
}

namespace {

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
    step_back(problem, options, fits);
    add_sides_apart(problem, options, fits);
    tell("sets of effects");
    Search result = ranked(problem, std::move(fits), options);
    tell("experiments left out");
    return result;
}

}  // namespace fusee::inference
