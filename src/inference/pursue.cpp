#include "fusee/inference/pursue.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/parallel.h"
#include "fusee/effects/term.h"
#include "fusee/inference/interval.h"
#include "fusee/inference/screen.h"

namespace fusee::inference {

namespace {

constexpr std::size_t kFitted = 4;  ///< terms fitted in full

std::vector<const char*> sides_of(const effects::Term& term) {
    if (!term.effect.sided) return {"none"};
    const bool ripple = term.effect.id.find("ripple") != std::string::npos;
    if (ripple) return {"agonist", "antagonist"};
    return {"agonist", "antagonist", "both"};
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

std::optional<FoundTerm> pursue_term(const Problem& problem, const Fit& null, double least, const SearchOptions& options) {
    const std::vector<effects::Cause> causes = possible_terms(problem.gap_case().rows);
    std::vector<Guess> guesses = screen(problem, null, causes, options.jobs);
    std::erase_if(guesses, [](const Guess& guess) { return !std::isfinite(guess.cost); });
    guesses.resize(std::min(kFitted, guesses.size()));
    std::vector<Fit> fits(guesses.size());
    const unsigned jobs_of_one = std::max(1U, options.jobs / std::max(1U, static_cast<unsigned>(guesses.size())));
    core::parallel_for(guesses.size(), options.jobs,
                       [&](std::size_t i) { fits[i] = fit(problem, guesses[i].causes, guesses[i].x, {.jobs = jobs_of_one}); });
    std::erase_if(fits, [&](const Fit& fit) { return !std::isfinite(fit.log_evidence) || !stands(problem, fit); });
    if (fits.empty()) return std::nullopt;
    std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.log_evidence > b.log_evidence; });
    FoundTerm found;
    found.log_odds = fits.front().log_evidence - kTermOdds - least;
    if (found.log_odds <= 0.0) return std::nullopt;
    double sum = std::exp(-found.log_odds);
    for (const Fit& other : fits) sum += std::exp(other.log_evidence - fits.front().log_evidence);
    found.probability = 1.0 / sum;
    found.fit = std::move(fits.front());
    found.left_out = experiments_left_out(problem, null, found.fit, options.jobs);
    if (!contradicted(problem, found.fit, found.left_out).empty() || !at_bounds(problem, found.fit).empty()) return std::nullopt;
    return found;
}

}  // namespace fusee::inference
