#include "ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/inference/interval.h"
#include "fusee/inference/screen.h"
#include "fusee/inference/splits.h"

namespace fusee::inference {

namespace {

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

}  // namespace

double score(const Problem& problem, const Fit& fit) {
    const bool unnamed = !fit.causes.empty() && std::abs(worst_nuisance_pull(problem, fit).sigmas) > kImpossible;
    return fit.log_evidence - odds_against(problem, fit) - (unnamed ? kSecondOdds : 0.0);
}

void sort_by_score(const Problem& problem, std::vector<Fit>& fits) {
    std::stable_sort(fits.begin(), fits.end(), [&](const Fit& a, const Fit& b) { return score(problem, a) > score(problem, b); });
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

std::optional<std::size_t> other_side(const Problem& problem, const Fit& fit, std::size_t c) {
    const auto size = [&](std::size_t of) { return fit.x[problem.effect_size_index(fit.causes, of)]; };
    for (std::size_t b = 0; b < c; ++b)
        if (fit.causes[b].id == fit.causes[c].id)
            return std::abs(size(b) - size(c)) >= kUnequal * std::max(std::abs(size(b)), std::abs(size(c))) ? std::optional(b)
                                                                                                            : std::nullopt;
    return std::nullopt;
}

double odds_against(const Problem& problem, const Fit& fit) {
    double odds = 0.0;
    for (std::size_t c = 0; c < fit.causes.size(); ++c)
        odds += c == 0 ? kEffectOdds : other_side(problem, fit, c) ? kOtherSideOdds : kSecondOdds;
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
    for (Fit& fit : fits) {
        if (!std::isfinite(fit.log_evidence) || !sizes_stand(problem, fit)) continue;
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

}  // namespace fusee::inference
