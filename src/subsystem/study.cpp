#include "study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <set>
#include <span>

#include "fusee/core/error.h"
#include "fusee/core/parallel.h"
#include "fusee/inference/constants.h"

namespace fusee::subsystem {

namespace {

/// Every set of up to `most` of the effects that this case can show, smaller sets first.
std::vector<std::vector<std::size_t>> sets_of(const Law& law, std::size_t most) {
    std::vector<std::vector<std::size_t>> sets{{}};
    for (std::size_t begin = 0, size = 1; size <= most; ++size) {
        const std::size_t end = sets.size();
        for (std::size_t s = begin; s < end; ++s)
            for (std::size_t e = sets[s].empty() ? 0 : sets[s].back() + 1; e < law.effects.size(); ++e) {
                if (!law.effects[e].unseen.empty()) continue;
                sets.push_back(sets[s]);
                sets.back().push_back(e);
            }
        begin = end;
    }
    return sets;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// If a set with one effect at its null value has a lower cost than the set without that effect, the smaller set stopped too
/// early: it continues from there.
void lower_subsets(const Law& law, Study& study) {
    for (std::size_t i = study.candidates.size(); i-- > 0;)
        for (const std::size_t e : study.candidates[i].effects) {
            std::vector<std::size_t> less = study.candidates[i].effects;
            std::erase(less, e);
            Candidate& without = study.candidates[static_cast<std::size_t>(study.find(less) - study.candidates.data())];
            Values start = study.candidates[i].fit.values;
            for (const std::size_t k : law.effects[e].parameters) start[k] = law.parameters[k].null_value;
            if (sum(misfit(law, start).squares) >= sum(without.seen.squares)) continue;
            without.fit = fit(law, all_blocks(law), without.fit.free, start);
            without.seen = misfit(law, without.fit.values);
        }
}

/// Own parameters of the records that a fold holds as a whole, fitted on its rows with all other values held.
Values with_own(const Law& law, const std::vector<std::size_t>& fold, const Values& values) {
    std::vector<std::size_t> own;
    for (std::size_t r = 0; r < law.own.size(); ++r) {
        const auto of_record = [&](std::size_t b) { return law.blocks[b].record == r; };
        const auto all = all_blocks(law);
        if (std::count_if(fold.begin(), fold.end(), of_record) == std::count_if(all.begin(), all.end(), of_record))
            own.insert(own.end(), law.own[r].begin(), law.own[r].end());
    }
    return own.empty() ? values : fit(law, fold, own, values, inference::kRefitSteps).values;
}

void keep_back(const Law& law, Candidate& candidate) {
    for (const Scheme& scheme : law.schemes) {
        Misfit unseen = candidate.seen;
        std::vector<Values> refits;
        for (const auto& [label, fold] : folds_of(scheme)) {
            const std::vector<std::size_t> rest = blocks_without(law, fold);
            if (rest.empty()) continue;
            Fit refit = fit(law, rest, candidate.fit.free, candidate.fit.values, inference::kRefitSteps);
            if (law.many_minima) {
                Fit other = fit_from_all_starts(law, rest, candidate.fit.free, candidate.fit.values);
                if (other.cost < refit.cost) refit = std::move(other);
            }
            refits.push_back(with_own(law, fold, refit.values));
            const Misfit there = misfit(law, refits.back());
            for (const std::size_t b : fold) unseen.squares[b] = there.squares[b];
        }
        candidate.unseen.push_back(std::move(unseen));
        candidate.refits.push_back(std::move(refits));
    }
}

/// n/(1 + 2 sum rho_k), the sum up to the first rho below 0 (the start of C. J. Geyer's initial sequences, Statistical Science 7, 1992).
double effective_count(const std::vector<double>& residuals) {
    const auto n = residuals.size();
    double square = 0.0;
    for (const double r : residuals) square += r * r;
    double time = 1.0;
    for (std::size_t lag = 1; lag < n / 2 && square > 0.0; ++lag) {
        double product = 0.0;
        for (std::size_t i = lag; i < n; ++i) product += residuals[i] * residuals[i - lag];
        if (product <= 0.05 * square) break;
        time += 2.0 * product / square;
    }
    return std::max(1.0, static_cast<double>(n) / time);
}

std::vector<double> effective_rows(const Law& law, const Values& values) {
    std::vector<double> counts;
    for (const Block& block : law.blocks) {
        const auto residuals = residuals_of(law, block.record, values);
        std::vector<double> rows;
        for (const std::size_t i : block.rows) rows.push_back(residuals[i]);
        counts.push_back(effective_count(rows));
    }
    return counts;
}

/// Sets whose evidence is above that of each set with one effect less, those sets, and the nominal law: the others are refused anyway.
/// With few files, also each effect alone: the answer states how it transfers.
std::vector<bool> worth_refits(const Law& law, const Study& study) {
    std::vector<bool> needed(study.candidates.size(), false);
    for (std::size_t i = 0; i < needed.size(); ++i) needed[i] = study.candidates[i].effects.size() <= (law.each_fold ? 1u : 0u);
    for (std::size_t i = 0; i < needed.size(); ++i) {
        std::vector<std::size_t> less;
        bool rises = true;
        for (const auto& subset : subsets_of(study.candidates[i].effects)) {
            const Candidate* without = study.find(subset);
            less.push_back(static_cast<std::size_t>(without - study.candidates.data()));
            rises = rises && study.candidates[i].log_evidence > without->log_evidence;
        }
        if (!rises) continue;
        needed[i] = true;
        for (const std::size_t l : less) needed[l] = true;
    }
    return needed;
}

/// Sets of `size` effects that hold one of the best of one less. Of each, the sets that it is judged against come before it.
std::vector<std::vector<std::size_t>> sets_upon_best(const Law& law, const Study& study, std::size_t size) {
    std::vector<const Candidate*> bases;
    for (const Candidate& t : study.candidates)
        if (t.effects.size() + 1 == size) bases.push_back(&t);
    const std::size_t kept = std::min(inference::kBases, bases.size());
    std::partial_sort(bases.begin(), bases.begin() + static_cast<std::ptrdiff_t>(kept), bases.end(),
                      [](const Candidate* a, const Candidate* b) { return a->log_evidence > b->log_evidence; });
    std::set<std::vector<std::size_t>> sets;
    for (std::size_t i = 0; i < kept; ++i)
        for (std::size_t e = 0; e < law.effects.size(); ++e) {
            std::vector<std::size_t> set = bases[i]->effects;
            if (!law.effects[e].unseen.empty() || std::find(set.begin(), set.end(), e) != set.end()) continue;
            set.insert(std::upper_bound(set.begin(), set.end(), e), e);
            sets.insert(set);
        }
    std::vector<std::vector<std::size_t>> ordered;
    for (const auto& set : sets)
        for (auto& subset : subsets_of(set))
            if (study.find(subset) == nullptr && std::find(ordered.begin(), ordered.end(), subset) == ordered.end())
                ordered.push_back(std::move(subset));
    ordered.insert(ordered.end(), sets.begin(), sets.end());
    return ordered;
}

/// Adds sets with their fits on all rows, those of one size at a time: they begin from the smaller ones. @param nominal of the first of all
void fit_sets(const Law& law, const std::vector<std::vector<std::size_t>>& sets, Values nominal, const diagnosis::DiagnoseOptions& options,
              const std::function<void(const char*)>& progress, Study& study) {
    for (std::size_t begin = 0; begin < sets.size();) {
        std::size_t end = begin;
        while (end < sets.size() && sets[end].size() == sets[begin].size()) ++end;
        if (!study.candidates.empty()) nominal = study.candidates.front().fit.values;
        std::vector<Candidate> fitted(end - begin);
        core::parallel_for(fitted.size(), options.jobs, [&](std::size_t i) {
            fitted[i].effects = sets[begin + i];
            fit_all(law, study, nominal, fitted[i]);
            progress("fit");
        });
        study.candidates.insert(study.candidates.end(), fitted.begin(), fitted.end());
        begin = end;
    }
}

/// The evidence of every set, with the rows counted by what the closest of them leaves.
void set_all_evidence(const Law& law, std::span<Study> studies) {
    const Candidate* closest = &studies.front().candidates.front();
    for (const Study& study : studies)
        for (const Candidate& candidate : study.candidates)
            if (candidate.seen_gap() < closest->seen_gap()) closest = &candidate;
    const std::vector<double> rows = effective_rows(law, closest->fit.values);
    for (Study& study : studies) {
        study.effective_rows = rows;
        for (Candidate& candidate : study.candidates) set_evidence(law, study, candidate);
    }
}

double most_evidence(const Study& study, std::size_t least, std::size_t most) {
    double evidence = -std::numeric_limits<double>::infinity();
    for (const Candidate& t : study.candidates)
        if (t.effects.size() >= least && t.effects.size() <= most) evidence = std::max(evidence, t.log_evidence);
    return evidence;
}

/// Adds all sets of up to law.whole_sets effects, then larger ones as long as the best of a size leads the best of one less.
void search_larger_sets(const Law& law, Study& study, const diagnosis::DiagnoseOptions& options,
                        const std::function<void(const char*)>& progress) {
    for (std::size_t size = study.candidates.back().effects.size() + 1; size <= law.most_effects; ++size) {
        std::vector<std::vector<std::size_t>> sets = size <= law.whole_sets ? sets_of(law, size) : sets_upon_best(law, study, size);
        std::erase_if(sets, [&](const auto& set) { return study.find(set) != nullptr; });
        fit_sets(law, sets, {}, options, progress, study);
        lower_subsets(law, study);
        set_all_evidence(law, {&study, 1});
        if (size > law.whole_sets &&
            most_evidence(study, size, size) < most_evidence(study, size - 1, size - 1) + inference::kLeastEvidence)
            return;
    }
}

/// Tries the answer with one effect more where that makes a larger set than law.most_effects: for the remarks alone.
void try_beside_best(const Law& law, Study& study, const diagnosis::DiagnoseOptions& options) {
    const std::vector<std::size_t> best = study.candidates[study.best].effects;
    if (best.size() < law.most_effects) return;
    std::vector<std::vector<std::size_t>> sets;
    for (std::size_t e = 0; e < law.effects.size(); ++e) {
        if (!law.effects[e].unseen.empty() || std::find(best.begin(), best.end(), e) != best.end()) continue;
        sets.push_back(best);
        sets.back().insert(std::upper_bound(sets.back().begin(), sets.back().end(), e), e);
    }
    const std::size_t before = study.candidates.size();
    fit_sets(
        law, sets, {}, options, [](const char*) {}, study);
    core::parallel_for(sets.size(), options.jobs, [&](std::size_t i) {
        Candidate& more = study.candidates[before + i];
        set_evidence(law, study, more);
        keep_back(law, more);
        if (law.each_fold) refuse(law, study, more);
        if (!more.refused.empty()) return;
        more.refused = study.candidates[study.best].unseen_gap(0) <= law.setup_floor ? "without it the model is at the floor"
                                                                                     : "no set has so many effects";
    });
}

}  // namespace

void require_rows(const Law& law) {
    std::size_t rows = 0;
    for (const Block& block : law.blocks) rows += block.rows.size();
    const std::size_t least = 2 * (law.nominal + 2);
    if (rows < least)
        throw core::InvalidInput("rows", std::to_string(rows), "at least " + std::to_string(least) + " in all files together");
    for (const Block& block : law.blocks)
        if (block.rows.empty()) throw core::InvalidInput(block.name, "no row to judge", "a file with more than one cycle");
}

void fit_all(const Law& law, const Study& study, const Values& nominal, Candidate& candidate) {
    const auto all = all_blocks(law), free = free_parameters(law, candidate.effects);
    candidate.fit = fit_from_all_starts(law, all, free, nominal);
    const Candidate* best = nullptr;
    for (const auto& subset : subsets_of(candidate.effects)) {
        const Candidate* without = study.find(subset);
        if (without != nullptr && (best == nullptr || without->fit.cost < best->fit.cost)) best = without;
    }
    if (best != nullptr) {
        Values start = best->fit.values;
        for (const std::size_t k : free)
            if (start[k] == law.parameters[k].null_value && !law.parameters[k].starts.empty()) start[k] = law.parameters[k].starts.front();
        Fit other = fit(law, all, free, start);
        if (other.cost < candidate.fit.cost) candidate.fit = std::move(other);
    }
    candidate.seen = misfit(law, candidate.fit.values);
}

void set_evidence(const Law& law, const Study& study, Candidate& candidate) {
    const double rows = sum(study.effective_rows);
    double square = 0.0;
    for (std::size_t b = 0; b < law.blocks.size(); ++b)
        square += study.effective_rows[b] * candidate.seen.squares[b] / candidate.seen.rows[b] / rows;
    const double scale = std::max(square, law.cycle_floor * law.cycle_floor);
    candidate.log_likelihood = -0.5 * rows * (std::log(scale) + square / scale);
    double priors = 0.0;
    for (std::size_t k = 0; k < law.parameters.size(); ++k)
        priors += std::pow(prior_residual(law.parameters[k], candidate.fit.values[k]), 2);
    candidate.log_evidence =
        candidate.log_likelihood - 0.5 * static_cast<double>(candidate.fit.free.size()) * std::log(rows) - 0.5 * priors;
}

double Candidate::seen_gap() const { return seen.gap(); }
double Candidate::unseen_gap(std::size_t scheme) const { return unseen[scheme].gap(); }
double Candidate::unseen_gap() const {
    double square = 0.0;
    for (const Misfit& misfit : unseen) square += sum(misfit.squares) / sum(misfit.rows) / static_cast<double>(unseen.size());
    return std::sqrt(square);
}

const Candidate* Study::find(std::vector<std::size_t> effects) const {
    std::sort(effects.begin(), effects.end());
    for (const Candidate& t : candidates)
        if (t.effects == effects) return &t;
    return nullptr;
}

double Study::probability_of(std::size_t effect) const {
    double probability = 0.0;
    for (const Candidate& t : candidates)
        if (std::find(t.effects.begin(), t.effects.end(), effect) != t.effects.end()) probability += t.probability;
    return probability;
}

namespace {

std::size_t choices_of(const Law& law) { return law.open_input ? law.open_input->choices.size() : 1; }

/// Sets that decide on the choice: with several of them, single effects.
std::vector<std::vector<std::size_t>> first_sets(const Law& law) { return sets_of(law, law.open_input ? 1 : law.whole_sets); }

/// The sets with their evidence, for the choice of law.open_input that has most of it; on a tie the first.
Study best_choice(const Law& law, const diagnosis::DiagnoseOptions& options, const std::function<void(const char*)>& progress) {
    std::vector<Study> tried;
    for (std::size_t c = 0; c < choices_of(law); ++c) {
        Values nominal = start_values(law);
        if (law.open_input) nominal[law.open_input->parameter] = law.open_input->choices[c].first;
        Study& study = tried.emplace_back();
        fit_sets(law, first_sets(law), std::move(nominal), options, progress, study);
        lower_subsets(law, study);
        study.choice = c;
    }
    set_all_evidence(law, tried);
    std::vector<double> most;
    for (const Study& study : tried) most.push_back(most_evidence(study, 0, law.whole_sets));
    const auto best = static_cast<std::size_t>(std::max_element(most.begin(), most.end()) - most.begin());
    Study study = std::move(tried[best]);
    study.choice_lead = most[best];
    most.erase(most.begin() + static_cast<std::ptrdiff_t>(best));
    if (!most.empty()) study.choice_lead -= *std::max_element(most.begin(), most.end());
    return study;
}

}  // namespace

Study study(const Law& law, const diagnosis::DiagnoseOptions& options) {
    require_rows(law);
    std::size_t parts = first_sets(law).size() * choices_of(law) + sets_of(law, law.whole_sets).size(), done = 0;
    std::mutex mutex;
    const std::function<void(const char*)> progress = [&](const char* what) {
        const std::lock_guard lock(mutex);
        parts = std::max(parts, ++done);  // nobody knows beforehand how many larger sets there are
        if (options.progress) options.progress(done, parts, what);
    };
    Study study = best_choice(law, options, progress);
    search_larger_sets(law, study, options, progress);
    const std::vector<bool> needed = worth_refits(law, study);
    core::parallel_for(study.candidates.size(), options.jobs, [&](std::size_t i) {
        if (needed[i]) keep_back(law, study.candidates[i]);
        progress("held-out files");
    });
    judge_candidates(law, study);
    try_beside_best(law, study, options);
    remark(law, study);
    return study;
}

}  // namespace fusee::subsystem
