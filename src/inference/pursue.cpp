#include "fusee/inference/pursue.h"

#include <algorithm>
#include <cmath>

#include "fusee/effects/term.h"
#include "fusee/inference/interval.h"
#include "fusee/inference/screen.h"

namespace fusee::inference {

namespace {

constexpr std::size_t kImproved = 12;  ///< terms that make a step in the screening
constexpr std::size_t kFitted = 3;     ///< terms fitted in full
constexpr std::size_t kMostTerms = 2;  ///< of an answer

std::vector<const char*> sides_of(const effects::Term& term) {
    if (!term.effect.sided) return {"none"};
    const bool ripple = term.effect.id.find("ripple") != std::string::npos;
    if (ripple) return {"agonist", "antagonist"};
    return {"agonist", "antagonist", "both"};
}

/// A term upon a base.
struct Added {
    Fit fit;
    double log_odds = 0.0, probability = 0.0;
};

/// Full fits of the best guesses that stand, the likeliest first.
std::vector<Fit> standing_fits(const Problem& problem, std::vector<Guess> guesses, const SearchOptions& options) {
    std::erase_if(guesses, [](const Guess& guess) { return !std::isfinite(guess.cost); });
    guesses.resize(std::min(kFitted, guesses.size()));
    std::vector<Fit> fits = fits_of(problem, guesses, options.jobs);
    std::erase_if(fits, [&](const Fit& fit) { return !std::isfinite(fit.log_evidence) || !stands(problem, fit); });
    std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.log_evidence > b.log_evidence; });
    return fits;
}

/// The best term upon `base`, if it exceeds `least` by its odds.
std::optional<Added> added_upon(const Problem& problem, const Fit& base, double least, const SearchOptions& options) {
    std::vector<effects::Cause> causes = possible_terms(problem.gap_case().rows);
    std::erase_if(causes, [&](const effects::Cause& cause) {
        return std::any_of(base.causes.begin(), base.causes.end(), [&](const effects::Cause& there) {
            return there == cause || (there.id == cause.id && (there.side == "both" || cause.side == "both"));
        });
    });
    std::vector<Fit> fits = standing_fits(problem, screen(problem, base, causes, options.jobs, kImproved), options);
    if (fits.empty()) return std::nullopt;
    Added added{{}, fits.front().log_evidence - kTermOdds - least, 0.0};
    if (!(added.log_odds > 0.0)) return std::nullopt;
    double sum = std::exp(-added.log_odds);
    for (const Fit& other : fits) sum += std::exp(other.log_evidence - fits.front().log_evidence);
    added.probability = 1.0 / sum;
    added.fit = std::move(fits.front());
    return added;
}

}  // namespace

std::vector<effects::Cause> possible_terms(const gap_case::Rows& rows) {
    std::vector<effects::Cause> causes;
    for (const effects::Term& term : effects::term_library()) {
        const std::vector<effects::Experiment>& seen = term.effect.seen_by;
        if (std::none_of(seen.begin(), seen.end(), [&](effects::Experiment e) { return rows.size(e) > 0; })) continue;
        for (const char* side : sides_of(term)) causes.push_back({term.effect.id, side});
    }
    return causes;
}

std::optional<FoundTerms> pursue_terms(const Problem& problem, const Fit& null, double least, const SearchOptions& options) {
    FoundTerms found{null, {}, {}, {}};
    while (found.log_odds.size() < kMostTerms) {
        std::optional<Added> next = added_upon(problem, found.fit, least, options);
        if (!next) break;
        Split left_out = experiments_left_out(problem, null, next->fit, options.jobs);
        if (!contradicted(problem, next->fit, left_out).empty() || !at_bounds(problem, next->fit).empty()) break;
        found.log_odds.push_back(next->log_odds);
        found.probability.push_back(next->probability);
        found.fit = std::move(next->fit);
        found.left_out = std::move(left_out);
        least = found.fit.log_evidence;
        if (explained(problem, found.fit)) break;
    }
    if (found.log_odds.empty()) return std::nullopt;
    return found;
}

}  // namespace fusee::inference
