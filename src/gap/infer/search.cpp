#include "search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "screen.h"

namespace fusee::gap {

namespace {

constexpr double kEffectOdds = 12.0;   ///< log odds against an effect: some sixty candidates, and rigs are mostly as designed [nat]
constexpr double kSecondOdds = 14.0;   ///< against a second one, which also likes to mend what the first one's law leaves open
constexpr std::size_t kSingles = 5;    ///< fitted in full
constexpr std::size_t kPairs = 3;      ///< upon each base
constexpr std::size_t kBases = 2;      ///< single effects upon which pairs are sought
constexpr double kWorthAPair = 60.0;   ///< a base is left out when it is so far behind the best one [nat]
constexpr double kNothingLeft = 1.15;  ///< T of every experiment at which no second effect is sought
constexpr double kStandsOff = 3.0;     ///< sigmas from 0 that an effect's size has to stand
constexpr double kLeastSize = 0.1;     ///< of what is usual: less is what a law leaves open, not an effect

double score(const Fit& fit) {
    return fit.log_evidence - (fit.causes.empty() ? 0.0 : kEffectOdds) - (fit.causes.size() > 1 ? kSecondOdds : 0.0);
}

void sort_by_score(std::vector<Fit>& fits) {
    std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return score(a) > score(b); });
}

/// Fits the best `count` guesses in full.
void fit_best(const Problem& problem, const std::vector<Guess>& guesses, std::size_t count, const SearchOptions& options,
              std::vector<Fit>& fits) {
    for (std::size_t i = 0; i < std::min(count, guesses.size()); ++i)
        fits.push_back(fit(problem, guesses[i].causes, guesses[i].x, {.jobs = options.jobs}));
}

/// Causes that may join `base`: of another effect.
std::vector<Cause> partners(const std::vector<Cause>& causes, const Fit& base) {
    std::vector<Cause> others;
    std::copy_if(causes.begin(), causes.end(), std::back_inserter(others),
                 [&](const Cause& cause) { return cause.id != base.causes.front().id; });
    return others;
}

bool same_causes(const Causes& a, const Causes& b) { return a.size() == b.size() && std::is_permutation(a.begin(), a.end(), b.begin()); }

void add_pairs(const Problem& problem, const std::vector<Cause>& causes, const std::vector<Fit>& singles, const SearchOptions& options,
               std::vector<Fit>& fits) {
    for (std::size_t i = 0; i < std::min(kBases, singles.size()); ++i) {
        const Fit& base = singles[i];
        if (score(base) < score(singles.front()) - kWorthAPair) break;
        std::vector<Guess> guesses = screen(problem, base, partners(causes, base), options.jobs);
        std::erase_if(guesses, [&](const Guess& guess) {
            return std::any_of(fits.begin(), fits.end(), [&](const Fit& known) { return same_causes(known.causes, guess.causes); });
        });
        fit_best(problem, guesses, kPairs, options, fits);
    }
}

/// Nothing is left for a second effect: every experiment is as near as its prediction is accurate.
bool explained(const Problem& problem, const Fit& fit) {
    const std::array<double, kExperiments> misfit = misfits(problem, fit.seen());
    return std::all_of(misfit.begin(), misfit.end(), [](double t) { return t < kNothingLeft; });
}

/// Every effect of the hypothesis is there: its size stands off 0, or it is a limit (a stop), which has no size of 0.
bool stands(const Problem& problem, const Fit& fit) {
    auto k = static_cast<Eigen::Index>(problem.build().size());
    for (const Cause& cause : fit.causes) {
        const Effect& effect = find_effect(cause.id);
        const bool limit = effect.parameters.front().allowed.low > 0.0;
        const double least = std::max(kLeastSize, kStandsOff * std::sqrt(fit.covariance(k, k)));
        if (!limit && std::abs(fit.x[k]) < least) return false;
        k += static_cast<Eigen::Index>(effect.parameters.size());
    }
    return true;
}

Search ranked(const Problem& problem, std::vector<Fit> fits) {
    Search result;
    std::erase_if(fits, [&](const Fit& fit) { return !stands(problem, fit); });
    sort_by_score(fits);
    double sum = 0.0;
    for (const Fit& fit : fits) {
        result.log_posterior.push_back(score(fit) - score(fits.front()));
        sum += std::exp(result.log_posterior.back());
    }
    for (const double log_posterior : result.log_posterior) result.probability.push_back(std::exp(log_posterior) / sum);
    result.null =
        static_cast<std::size_t>(std::find_if(fits.begin(), fits.end(), [](const Fit& fit) { return fit.causes.empty(); }) - fits.begin());
    result.fits = std::move(fits);
    return result;
}

}  // namespace

Search search(const Problem& problem, const SearchOptions& options) {
    const std::vector<Cause> causes = possible_causes(problem.bench().rows);
    const auto tell = [&](const char* what) {
        if (options.told) options.told(what);
    };
    std::vector<Fit> fits{fit(problem, {}, problem.start({}), {.jobs = options.jobs})};
    tell("build tolerances");
    std::vector<Fit> singles;
    const std::vector<Guess> guesses = screen(problem, fits.front(), causes, options.jobs);
    tell("screening of single effects");
    fit_best(problem, guesses, kSingles, options, singles);
    sort_by_score(singles);
    tell("single effects");
    const bool found = !singles.empty() && score(singles.front()) > score(fits.front());
    for (const Fit& single : singles) fits.push_back(single);
    if (found && !explained(problem, singles.front())) add_pairs(problem, causes, singles, options, fits);
    tell("pairs of effects");
    return ranked(problem, std::move(fits));
}

}  // namespace fusee::gap
