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

/// A fit that strains a build parameter is tried again with such parameters at 0: they had replaced what the term explains now.
Fit relaxed(const Problem& problem, Fit found, unsigned jobs) {
    if (std::abs(worst_nuisance_pull(problem, found).sigmas) <= kImpossible) return found;
    Eigen::VectorXd x = found.x;
    for (std::size_t k = 0; k < problem.build().size(); ++k)
        if (double& value = x[static_cast<Eigen::Index>(k)]; std::abs(value) > kStrained) value = 0.0;
    Fit again = fit(problem, found.causes, x, {.jobs = jobs});
    return again.log_evidence > found.log_evidence ? again : found;
}

/// Full fits of the best guesses whose sizes stand, the likeliest first.
std::vector<Fit> standing_fits(const Problem& problem, std::vector<Guess> guesses, const SearchOptions& options) {
    std::erase_if(guesses, [](const Guess& guess) { return !std::isfinite(guess.cost); });
    guesses.resize(std::min(kFitted, guesses.size()));
    std::vector<Fit> fits = fits_of(problem, guesses, options.jobs);
    for (Fit& fit : fits) fit = relaxed(problem, std::move(fit), options.jobs);
    std::erase_if(fits, [&](const Fit& fit) { return !std::isfinite(fit.log_evidence) || !sizes_stand(problem, fit); });
    std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.log_evidence > b.log_evidence; });
    return fits;
}

/// The best term upon `base`, if it exceeds `least` by its odds.
std::optional<Added> added_upon(const Problem& problem, const Fit& base, double least, std::vector<effects::Cause> causes,
                                const SearchOptions& options) {
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

/// A term whose partner is still missing may strain the build parameters and differ from experiment to experiment; an answer may not.
bool trusted(const Problem& problem, const FoundTerms& found) {
    return stands(problem, found.fit) && contradicted(problem, found.fit, found.left_out).empty();
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

std::vector<effects::Cause> terms_like(const gap_case::Rows& rows, const std::string& effect) {
    std::vector<effects::Cause> causes = possible_terms(rows);
    std::erase_if(causes, [&](const effects::Cause& cause) {
        const std::vector<std::string>& like = effects::term_or_none(cause.id)->effect.confused_with;
        return std::find(like.begin(), like.end(), effect) == like.end();
    });
    return causes;
}

std::optional<FoundTerms> pursue_terms(const Problem& problem, const Fit& null, double least, const std::vector<effects::Cause>& terms,
                                       const SearchOptions& options) {
    FoundTerms found{null, {}, {}, {}};
    std::optional<FoundTerms> good;
    while (found.log_odds.size() < kMostTerms) {
        std::optional<Added> next = added_upon(problem, found.fit, least, terms, options);
        if (!next) break;
        if (!at_bounds(problem, next->fit).empty()) break;
        found.log_odds.push_back(next->log_odds);
        found.probability.push_back(next->probability);
        found.fit = std::move(next->fit);
        found.left_out = experiments_left_out(problem, null, found.fit, options.jobs);
        least = found.fit.log_evidence;
        if (trusted(problem, found)) good = found;
        if (explained(problem, found.fit)) break;
    }
    return good;
}

}  // namespace fusee::inference
