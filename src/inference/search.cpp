#include "fusee/inference/search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "fusee/inference/constants.h"
#include "fusee/inference/interval.h"
#include "fusee/inference/screen.h"
#include "refine.h"

namespace fusee::inference {

namespace {

/// docs/theory/diagnosis.md, eq. 13 and 14.
double score(const Fit& fit) {
    return fit.log_evidence - (fit.causes.empty() ? 0.0 : kEffectOdds) - (fit.causes.size() > 1 ? kSecondOdds : 0.0);
}

void sort_by_score(std::vector<Fit>& fits) {
    std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return score(a) > score(b); });
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

/// Causes that may join `base`: of another effect.
std::vector<Cause> partners(const std::vector<Cause>& causes, const Fit& base) {
    std::vector<Cause> others;
    std::copy_if(causes.begin(), causes.end(), std::back_inserter(others),
                 [&](const Cause& cause) { return cause.id != base.causes.front().id; });
    return others;
}

bool same_causes(const Causes& a, const Causes& b) { return a.size() == b.size() && std::is_permutation(a.begin(), a.end(), b.begin()); }

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

/// Pairs of any cause with the best single ones.
void add_pairs(const Problem& problem, const std::vector<Cause>& causes, const std::vector<Fit>& singles, const SearchOptions& options,
               std::vector<Fit>& fits) {
    for (std::size_t i = 0; i < std::min(kBases, singles.size()); ++i) {
        const Fit& base = singles[i];
        if (score(base) < score(singles.front()) - kWorthAPair) break;
        add_best(problem, screen(problem, base, partners(causes, base), options.jobs), options, fits);
    }
}

/// Pairs of the single ones with each other: two great effects hide each other, so that each alone may be far from the best.
void add_pairs_of_singles(const Problem& problem, const std::vector<Fit>& singles, const SearchOptions& options, std::vector<Fit>& fits) {
    std::vector<Cause> causes;
    for (const Fit& single : singles) causes.push_back(single.causes.front());
    std::vector<Guess> guesses;
    for (const Fit& base : singles)
        for (Guess& guess : screen(problem, base, partners(causes, base), options.jobs)) guesses.push_back(std::move(guess));
    std::stable_sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) { return a.cost < b.cost; });
    std::vector<Guess> different;
    for (Guess& guess : guesses)
        if (std::none_of(different.begin(), different.end(), [&](const Guess& d) { return same_causes(d.causes, guess.causes); }))
            different.push_back(std::move(guess));
    add_best(problem, std::move(different), options, fits);
}

/// Does a hypothesis that stands explain all?
bool any_explains(const Problem& problem, const std::vector<Fit>& fits) {
    return std::any_of(fits.begin(), fits.end(), [&](const Fit& fit) { return stands(problem, fit) && explained(problem, fit); });
}

/// The best hypotheses that do not explain all are searched again: a fit in a local minimum may be strained, and would be left out.
void search_again(const Problem& problem, const SearchOptions& options, std::vector<Fit>& fits) {
    sort_by_score(fits);
    for (std::size_t i = 0; i < std::min(kRefined, fits.size()); ++i)
        if (!fits[i].causes.empty() && !explained(problem, fits[i]))
            fits[i] = searched_again(problem, relaxed(problem, std::move(fits[i]), options.jobs), options.jobs);
}

/// The best pair without one of its effects, started at the pair: a single fit that stopped elsewhere would make its
/// partner look necessary.
void step_back(const Problem& problem, const SearchOptions& options, std::vector<Fit>& fits) {
    const Fit best = *std::max_element(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return score(a) < score(b); });
    if (best.causes.size() < 2) return;
    for (const Cause& kept : best.causes) {
        Fit single = fit(problem, {kept}, problem.without_others(best.causes, best.x, kept), {.jobs = options.jobs});
        const auto known = std::find_if(fits.begin(), fits.end(), [&](const Fit& other) { return other.causes == single.causes; });
        if (known == fits.end())
            append(fits, {std::move(single)});
        else if (score(single) > score(*known))
            *known = std::move(single);
    }
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
    sort_by_score(singles);
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
    const auto unchecked = [](const Ranked& h) { return h.left_out.x.empty(); };
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

/// As `discount_unfounded`, then sorted again.
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

Search ranked(const Problem& problem, std::vector<Fit> fits, const SearchOptions& options) {
    std::erase_if(fits, [&](const Fit& fit) { return !stands(problem, fit); });
    sort_by_score(fits);
    std::vector<Ranked> ranking;
    for (Fit& fit : fits) {
        const double of_fit = score(fit);
        ranking.push_back({std::move(fit), of_fit, {}});
    }
    penalize_contradicted(problem, ranking, options);
    penalize_unfounded(ranking);
    Search result;
    double sum = 0.0;
    for (Ranked& h : ranking) {
        if (h.fit.causes.empty()) result.null = result.fits.size();
        result.log_posterior.push_back(h.score - ranking.front().score);
        sum += std::exp(result.log_posterior.back());
        result.fits.push_back(std::move(h.fit));
        result.left_out.push_back(std::move(h.left_out));
    }
    for (const double log_posterior : result.log_posterior) result.probability.push_back(std::exp(log_posterior) / sum);
    return result;
}

}  // namespace

bool explained(const Problem& problem, const Fit& fit) {
    if (std::abs(worst_nuisance_pull(problem, fit).sigmas) > kStretched) return false;
    const std::vector<double> misfit = misfits(problem, fit.seen());
    return std::all_of(misfit.begin(), misfit.end(), [](double t) { return t < kNothingLeft; });
}

bool stands(const Problem& problem, const Fit& fit) {
    return sizes_stand(problem, fit) && (fit.causes.empty() || std::abs(worst_nuisance_pull(problem, fit).sigmas) <= kImpossible);
}

bool sizes_stand(const Problem& problem, const Fit& fit) {
    for (std::size_t c = 0; c < fit.causes.size(); ++c) {
        const int k = problem.effect_size_index(fit.causes, c);
        const double least = std::max(kLeastSize, kStandsOff * std::sqrt(fit.covariance(k, k)));
        if (!problem.effect(fit.causes[c].id).is_limit() && std::abs(fit.x[k]) < least) return false;
    }
    return true;
}

void discount_unfounded(std::span<const std::size_t> effects, std::span<double> scores) {
    double none = -std::numeric_limits<double>::infinity(), one = none;
    for (std::size_t h = 0; h < scores.size(); ++h) {
        if (effects[h] == 0) none = std::max(none, scores[h]);
        if (effects[h] == 1) one = std::max(one, scores[h]);
    }
    for (std::size_t h = 0; h < scores.size() && one <= none; ++h)
        if (effects[h] > 1) scores[h] -= kContradicted;
}

Search search(const Problem& problem, const SearchOptions& options) {
    const std::vector<Cause> causes = possible_causes(problem);
    const auto tell = [&](const char* what) {
        if (options.progress) options.progress(what);
    };
    std::vector<Fit> fits{fit(problem, {}, problem.start({}), {.jobs = options.jobs})};
    tell("build tolerances");
    const std::vector<Guess> guesses = screen(problem, fits.front(), causes, options.jobs);
    tell("screening of single effects");
    const std::vector<Fit> singles = singles_of(problem, fits.front(), guesses, options);
    tell("single effects");
    const bool found = !singles.empty() && score(singles.front()) > score(fits.front());
    for (const Fit& single : singles) fits.push_back(single);
    if (found && !explained(problem, singles.front())) {
        add_pairs(problem, causes, singles, options, fits);
        if (!any_explains(problem, fits)) add_pairs_of_singles(problem, singles, options, fits);
    }
    if (!any_explains(problem, fits)) search_again(problem, options, fits);
    step_back(problem, options, fits);
    tell("pairs of effects");
    Search result = ranked(problem, std::move(fits), options);
    tell("experiments left out");
    return result;
}

}  // namespace fusee::inference
