#include "fusee/inference/pursue.h"

#include <algorithm>
#include <cmath>

#include "fusee/inference/interval.h"
#include "fusee/inference/screen.h"
#include "refine.h"

namespace fusee::inference {

namespace {

/// Full fits of the best guesses whose sizes stand.
std::vector<Fit> standing_fits(const Problem& problem, std::vector<Guess> guesses, const SearchOptions& options) {
    std::erase_if(guesses, [](const Guess& guess) { return !std::isfinite(guess.cost); });
    guesses.resize(std::min(kFitted, guesses.size()));
    std::vector<Fit> fits = fits_of(problem, guesses, options.jobs);
    for (Fit& fit : fits) fit = relaxed(problem, std::move(fit), options.jobs);
    std::erase_if(fits, [&](const Fit& fit) { return !std::isfinite(fit.log_evidence) || !sizes_stand(problem, fit); });
    return fits;
}

/// Those of `causes` that are the last term of `base` on its other side.
std::vector<Cause> on_other_side(std::vector<Cause> causes, const Fit& base) {
    std::erase_if(causes, [&](const Cause& cause) { return cause.id != base.causes.back().id; });
    return causes;
}

/// Fits with one term more, the likeliest first: any term upon the best base; upon each other base its own term on the other side,
/// since of a term on both sides either half alone may look worse than something else.
std::vector<Fit> fits_upon(const Problem& problem, const std::vector<Fit>& bases, const std::vector<Cause>& terms,
                           const SearchOptions& options) {
    std::vector<Fit> fits;
    for (const Fit& base : bases) {
        std::vector<Cause> causes = causes_beside(terms, base.causes);
        if (&base != &bases.front()) causes = on_other_side(std::move(causes), base);
        for (Fit& fit : standing_fits(problem, screen(problem, base, causes, options.jobs, kImproved), options))
            fits.push_back(std::move(fit));
    }
    const auto likelier = [](const Fit& a, const Fit& b) { return a.log_evidence > b.log_evidence; };
    std::stable_sort(fits.begin(), fits.end(), likelier);
    if (!fits.empty()) fits.front() = searched_again(problem, std::move(fits.front()), options.jobs);
    return fits;
}

/// Probability of the first among the fits and the hypothesis that it exceeds by its odds.
double share_of_first(const std::vector<Fit>& fits, double log_odds) {
    double sum = std::exp(-log_odds);
    for (const Fit& fit : fits) sum += std::exp(fit.log_evidence - fits.front().log_evidence);
    return 1.0 / sum;
}

/// Puts the first of `fits` in the place of the terms that were found so far. Terms that are new have the figures of this step.
void add_first(const std::vector<Fit>& fits, double log_odds, FoundTerms& found) {
    const Fit& first = fits.front();
    std::vector<double> odds(first.causes.size(), log_odds), probability(first.causes.size(), share_of_first(fits, log_odds));
    for (std::size_t c = 0; c < found.fit.causes.size(); ++c) {
        const auto at = std::find(first.causes.begin(), first.causes.end(), found.fit.causes[c]) - first.causes.begin();
        if (at == std::ssize(first.causes)) continue;
        odds[static_cast<std::size_t>(at)] = found.log_odds[c];
        probability[static_cast<std::size_t>(at)] = found.probability[c];
    }
    found.fit = first;
    found.log_odds = std::move(odds);
    found.probability = std::move(probability);
}

/// No size is at a bound; a limit may be: a cable that always slips does so above a force of none.
bool sizes_within(const Problem& problem, const Fit& fit) {
    const Causes out = at_bounds(problem, fit);
    return std::all_of(out.begin(), out.end(), [&](const Cause& cause) { return problem.effect(cause.id).is_limit(); });
}

/// A term whose partner is still missing may strain the build parameters and differ from experiment to experiment; an answer may not.
bool trusted(const Problem& problem, const FoundTerms& found) {
    return sizes_stand(problem, found.fit) && std::abs(worst_nuisance_pull(problem, found.fit).sigmas) <= kImpossible &&
           contradicted(problem, found.fit, found.left_out).empty();
}

}  // namespace

std::vector<Cause> possible_terms(const Problem& problem) { return possible_causes(problem, true); }

std::vector<Cause> terms_like(const Problem& problem, const std::string& effect) {
    std::vector<Cause> causes = possible_terms(problem);
    std::erase_if(causes, [&](const Cause& cause) {
        const std::vector<std::string>& like = problem.effect(cause.id).confused_with;
        return std::find(like.begin(), like.end(), effect) == like.end();
    });
    return causes;
}

std::optional<FoundTerms> pursue_terms(const Problem& problem, const Fit& null, double least, const std::vector<Cause>& terms,
                                       const SearchOptions& options) {
    FoundTerms found{null, {}, {}, {}};
    std::optional<FoundTerms> good;
    std::vector<Fit> bases{null};
    double cost = 0.0;  // of the terms upon what is to be beaten [nats]
    for (std::size_t terms_of_fit = 1; terms_of_fit <= kMostTerms; ++terms_of_fit) {
        std::vector<Fit> fits = fits_upon(problem, bases, terms, options);
        if (fits.empty() || !sizes_within(problem, fits.front())) break;
        cost += kTermOdds;
        const double log_odds = fits.front().log_evidence - cost - least;
        if (log_odds < (kHalf - 1.0) * kTermOdds) break;
        if (log_odds > 0.0) {
            add_first(fits, log_odds, found);
            found.left_out = experiments_left_out(problem, null, found.fit, options.jobs);
            least = found.fit.log_evidence;
            cost = 0.0;
            if (trusted(problem, found)) good = found;
            if (explained(problem, found.fit)) break;
        }
        bases = std::move(fits);
    }
    return good;
}

Reconsidered reconsidered(const Problem& problem, Search found, FoundTerms terms, unsigned jobs) {
    const auto build = static_cast<Eigen::Index>(problem.build().size());
    Eigen::VectorXd start = found.best().x;
    start.head(build) = terms.fit.x.head(build);
    const double before = found.best().log_evidence;
    Fit again = fit(problem, found.best().causes, start, {.jobs = jobs});
    found = with_fits(problem, std::move(found), {std::move(again)}, jobs);
    const bool beaten = terms.log_odds.front() > found.best().log_evidence - before;
    return {std::move(found), beaten ? std::optional(std::move(terms)) : std::nullopt};
}

}  // namespace fusee::inference
