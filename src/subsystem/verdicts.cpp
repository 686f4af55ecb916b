#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "fusee/inference/search.h"
#include "study.h"

namespace fusee::subsystem {

namespace {

constexpr const char* kNoEvidence = "the evidence does not rise by 5 nats";
constexpr std::uint64_t kSeed = 20240518;

/// Mean of ln(square without / square with) over the blocks, in its standard errors. With few blocks: inference::kLeastErrors.
double standard_errors(const Candidate& with, const Candidate& without) {
    const std::size_t n = with.seen.rows.size();
    if (n < 3) return inference::kLeastErrors;
    double mean = 0.0, square = 0.0;
    std::vector<double> falls;
    for (std::size_t b = 0; b < n; ++b)
        falls.push_back(std::log((without.unseen[0].mean_square(b) + 1e-12) / (with.unseen[0].mean_square(b) + 1e-12)));
    for (const double f : falls) mean += f / static_cast<double>(n);
    for (const double f : falls) square += (f - mean) * (f - mean);
    return mean / std::sqrt(square / static_cast<double>(n * (n - 1)) + 1e-18);
}

std::string from_to(const Law& law, double from, double to) {
    return fmt::format("from {:.4g} to {:.4g} {}", from * law.unit_sigma, to * law.unit_sigma, law.unit);
}

/// The half of a split in two whose held-out error does not fall; "" if both fall.
std::string not_lowered(const Law& law, const Candidate& with, const Candidate& without) {
    for (std::size_t s = 0; s < law.schemes.size(); ++s) {
        const std::vector<Fold> folds = folds_of(law.schemes[s]);
        if (folds.size() != 2) continue;
        for (const auto& [label, blocks] : folds) {
            const double before = without.unseen[s].mean_square(blocks), after = with.unseen[s].mean_square(blocks);
            if (after > (1.0 - inference::kLeastFall) * before)
                return fmt::format("it does not transfer: on {}, held out, it changes the error {}", label,
                                   from_to(law, std::sqrt(before), std::sqrt(after)));
        }
    }
    return "";
}

/// Why an effect is not justified against the set without it; "" if it is.
std::string refusal(const Law& law, const LawEffect& effect, const Candidate& with, const Candidate& without) {
    if (with.log_evidence - without.log_evidence < inference::kLeastEvidence) return kNoEvidence;
    if (const std::string end = stopped_at(law, effect.parameters, with.fit.values); !end.empty())
        return fmt::format("the search stopped {}: no size is found", end);
    if (with.unseen.empty() || without.unseen.empty()) return "";  // another of its effects does not raise the evidence
    const double floor = effect.moves_setups ? 1.0 : law.setup_floor;
    if (without.unseen_gap(0) <= floor) return "without it the model is at the floor";
    for (std::size_t s = 0; s < law.schemes.size(); ++s)
        if (std::pow(with.unseen_gap(s) / without.unseen_gap(s), 2) > 1.0 - inference::kLeastFall)
            return fmt::format("it does not predict the rows held out by {}", law.schemes[s].name);
    if (law.each_fold)
        if (std::string half = not_lowered(law, with, without); !half.empty()) return half;
    if (standard_errors(with, without) < inference::kLeastErrors)
        return fmt::format("on held-out files its gain is below {:g} standard error: it comes from a few files", inference::kLeastErrors);
    return "";
}

/// Normalized exponential draws of a portable seeded generator: Dirichlet(1, ..., 1).
std::vector<double> dirichlet(std::mt19937_64& random, std::size_t n) {
    std::vector<double> weights(n);
    double sum = 0.0;
    for (double& w : weights) sum += w = -std::log((static_cast<double>(random() >> 11) + 0.5) * 0x1p-53);
    for (double& w : weights) w /= sum;
    return weights;
}

std::vector<Candidate*> left(Study& study) {
    std::vector<Candidate*> sets;
    for (Candidate& t : study.candidates)
        if (t.refused.empty()) sets.push_back(&t);
    return sets;
}

/// log density of the held-out blocks, the mean over the schemes; one scale for all sets.
std::vector<std::vector<double>> block_scores(const Law& law, const Study& study, const std::vector<Candidate*>& sets) {
    double scale = law.setup_floor * law.setup_floor;
    double least = std::numeric_limits<double>::infinity();
    for (const Candidate* t : sets) least = std::min(least, t->unseen_gap());
    scale = std::max(scale, least * least);
    std::vector<std::vector<double>> scores;
    for (const Candidate* t : sets) {
        std::vector<double> of_blocks(law.blocks.size(), 0.0);
        for (const Misfit& m : t->unseen)
            for (std::size_t b = 0; b < of_blocks.size(); ++b)
                of_blocks[b] -= 0.5 * study.effective_rows[b] * m.mean_square(b) / scale / static_cast<double>(t->unseen.size());
        scores.push_back(std::move(of_blocks));
    }
    return scores;
}

/// Sum of squares of each set on each fold of a scheme.
std::vector<std::vector<double>> squares_of_sets(const Law& law, std::size_t scheme, const std::vector<Candidate*>& sets) {
    std::vector<std::vector<double>> squares;
    for (const Fold& fold : folds_of(law.schemes[scheme])) {
        squares.emplace_back(sets.size(), 0.0);
        for (const std::size_t b : fold.blocks)
            for (std::size_t i = 0; i < sets.size(); ++i) squares.back()[i] += sets[i]->unseen[scheme].squares[b];
    }
    return squares;
}

/// Share of the folds of all schemes that each set predicts best; sets that are equal to a per mille share.
std::vector<double> shares_of_folds(const Law& law, const std::vector<Candidate*>& sets) {
    std::vector<double> wins(sets.size(), 0.0);
    double folds = 0.0;
    for (std::size_t s = 0; s < law.schemes.size(); ++s) {
        for (const auto& sums : squares_of_sets(law, s, sets)) {
            const double least = *std::min_element(sums.begin(), sums.end());
            const auto best = [&](double square) { return square <= 1.001 * least; };
            const auto ties = static_cast<double>(std::count_if(sums.begin(), sums.end(), best));
            for (std::size_t i = 0; i < sets.size(); ++i)
                if (best(sums[i])) wins[i] += 1.0 / ties;
            folds += 1.0;
        }
    }
    for (double& w : wins) w /= folds;
    return wins;
}

void weigh(const Law& law, Study& study) {
    const std::vector<Candidate*> sets = left(study);
    const auto scores = block_scores(law, study, sets);
    std::vector<std::vector<double>> draws;
    std::vector<double> weights(sets.size(), 0.0);
    std::mt19937_64 random(kSeed);
    const auto blocks = static_cast<double>(law.blocks.size());
    for (int d = 0; d < inference::kWeightDraws; ++d) {
        draws.push_back(dirichlet(random, law.blocks.size()));
        std::vector<double> sums;
        for (std::size_t i = 0; i < sets.size(); ++i)
            sums.push_back(blocks * std::inner_product(scores[i].begin(), scores[i].end(), draws.back().begin(), 0.0) -
                           0.5 * static_cast<double>(sets[i]->fit.free.size()));
        const auto shares = inference::probabilities(sums);
        for (std::size_t i = 0; i < sets.size(); ++i) weights[i] += shares[i] / inference::kWeightDraws;
    }
    const auto folds = shares_of_folds(law, sets);
    std::size_t best = 0;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        sets[i]->probability = 0.5 * (weights[i] + folds[i]);
        if (sets[i]->probability > sets[best]->probability) best = i;
    }
    study.best = static_cast<std::size_t>(sets[best] - study.candidates.data());
    study.stability = folds[best];
    share_among_equals(law, study);
    std::vector<double> gaps;
    for (const auto& draw : draws) {
        const Misfit& m = study.candidates[study.best].unseen[0];
        gaps.push_back(std::sqrt(std::inner_product(draw.begin(), draw.end(), m.squares.begin(), 0.0) /
                                 std::inner_product(draw.begin(), draw.end(), m.rows.begin(), 0.0)));
    }
    std::sort(gaps.begin(), gaps.end());
    study.heldout_after_95 = {gaps[inference::kWeightDraws / 40], gaps[inference::kWeightDraws - 1 - inference::kWeightDraws / 40]};
}

/// The set in which the effect improves the fit and worsens the held-out rows most, if any: a false cause.
std::string false_cause(const Law& law, const Study& study, std::size_t e) {
    std::string text;
    double worst = 1.0;
    for (const Candidate& base : study.candidates) {
        if (!base.refused.empty() || base.unseen.empty()) continue;
        std::vector<std::size_t> more = base.effects;
        more.push_back(e);
        const Candidate* with = study.find(more);
        if (with == nullptr || with->unseen.empty() || with->seen_gap() >= base.seen_gap()) continue;
        for (std::size_t s = 0; s < law.schemes.size(); ++s) {
            const double ratio = with->unseen_gap(s) / base.unseen_gap(s);
            if (ratio <= worst) continue;
            worst = ratio;
            text = fmt::format("{} is a false cause: added to {} it improves the fit {} and worsens the rows held out by {} {}",
                               name_of(law.effects[e]), name_of(law, base.effects), from_to(law, base.seen_gap(), with->seen_gap()),
                               law.schemes[s].name, from_to(law, base.unseen_gap(s), with->unseen_gap(s)));
        }
    }
    return text;
}

/// What each other effect changes if it is added to the answer.
void remark_on_refused(const Law& law, Study& study) {
    const Candidate best = study.candidates[study.best];
    for (std::size_t e = 0; e < law.effects.size(); ++e) {
        if (std::find(best.effects.begin(), best.effects.end(), e) != best.effects.end()) continue;
        if (!law.effects[e].unseen.empty()) {
            study.remarks.push_back(fmt::format("{} cannot be seen here: {}", name_of(law.effects[e]), law.effects[e].unseen));
            continue;
        }
        std::vector<std::size_t> more = best.effects;
        more.push_back(e);
        const Candidate* with = study.find(more);
        if (with == nullptr || with->refused.empty()) continue;
        std::string text = fmt::format("{} is refused: added to {} it changes the fit {}", name_of(law.effects[e]),
                                       name_of(law, best.effects), from_to(law, best.seen_gap(), with->seen_gap()));
        if (!with->unseen.empty()) text += fmt::format(", held-out rows {}", from_to(law, best.unseen_gap(0), with->unseen_gap(0)));
        study.remarks.push_back(text + "; " + with->refused);
        if (law.each_fold) continue;  // transfer_remarks state it file by file
        if (const std::string lure = false_cause(law, study, e); !lure.empty()) study.remarks.push_back(lure);
    }
}

/// Splits with another best set.
void remark_on_splits(const Law& law, Study& study) {
    const std::vector<Candidate*> sets = left(study);
    for (std::size_t s = 0; s < law.schemes.size(); ++s) {
        const auto squares = squares_of_sets(law, s, sets);
        std::map<std::string, std::size_t> wins;
        for (const auto& sums : squares) {
            const auto i = static_cast<std::size_t>(std::min_element(sums.begin(), sums.end()) - sums.begin());
            ++wins[name_of(law, sets[i]->effects)];
        }
        if (wins.size() < 2) continue;
        std::string text = fmt::format("the ranking changes with the rows held out by {}:", law.schemes[s].name);
        for (const auto& [name, won] : wins) text += fmt::format(" {} is best on {} of {};", name, won, squares.size());
        text.pop_back();
        study.remarks.push_back(text + ": one split alone is not evidence");
    }
}

}  // namespace

std::string stopped_at(const Law& law, const std::vector<std::size_t>& parameters, const Values& values) {
    for (const std::size_t k : parameters) {
        const Parameter& p = law.parameters[k];
        if (!p.stops_at(values[k])) continue;
        const std::string unit = p.unit.empty() ? "" : " " + p.unit;
        return fmt::format("{}at {:.4g}{}, an end of its range ({:.4g} to {:.4g}{})", k == parameters.front() ? "" : "with " + p.name + " ",
                           values[k], unit, p.low, p.high, unit);
    }
    return "";
}

std::string name_of(const LawEffect& effect) {
    return effect.cause.side == "none" ? effect.cause.id : effect.cause.id + " (" + effect.cause.side + ")";
}

std::string name_of(const Law& law, const std::vector<std::size_t>& effects) {
    if (effects.empty()) return "no effect";
    std::string name;
    for (const std::size_t e : effects) name += (name.empty() ? "" : " + ") + name_of(law.effects[e]);
    return name;
}

void refuse(const Law& law, const Study& study, Candidate& candidate) {
    const auto subsets = subsets_of(candidate.effects);
    for (std::size_t i = 0; i < subsets.size(); ++i) {
        const std::size_t e = candidate.effects[i];
        const std::string why = refusal(law, law.effects[e], candidate, *study.find(subsets[i]));
        if (why.empty()) continue;
        candidate.refused = name_of(law.effects[e]) + ": " + why;
        candidate.unlikely = why == kNoEvidence;
        const std::string end = stopped_at(law, law.effects[e].parameters, candidate.fit.values);
        if (!candidate.unlikely && !end.empty()) candidate.stopped = e;
        return;
    }
}

void judge_candidates(const Law& law, Study& study) {
    for (Candidate& candidate : study.candidates) refuse(law, study, candidate);
    weigh(law, study);
}

void remark(const Law& law, Study& study) {
    remark_on_refused(law, study);
    remark_on_splits(law, study);
}

}  // namespace fusee::subsystem
