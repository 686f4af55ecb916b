#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/inference/search.h"
#include "study.h"

namespace fusee::subsystem {

namespace {

bool at_end(const Law& law, const Candidate& set) {
    return std::any_of(set.effects.begin(), set.effects.end(),
                       [&](std::size_t e) { return !stopped_at(law, law.effects[e].parameters, set.fit.values).empty(); });
}

bool plausible(const Law& law, const Candidate& set) {
    for (std::size_t k = 0; k < law.nominal; ++k)
        if (std::abs(prior_residual(law.parameters[k], set.fit.values[k])) > inference::kPlausible) return false;
    return true;
}

/// One file: what is held out are its parts, and a set that is right in the middle of the law can miss them at its ends.
bool in_parts(const Law& law) { return law.schemes.front().name == "part"; }

bool needs_each(const Study& study, const Candidate& set) {
    const auto subsets = subsets_of(set.effects);
    return std::all_of(subsets.begin(), subsets.end(), [&](const auto& subset) {
        return set.log_evidence - study.find(subset)->log_evidence >= inference::kLeastEvidence;
    });
}

/// No fewer rows are explained, with no more effects.
bool is_equal(const Law& law, const Study& study, const Candidate& set) {
    const Candidate& best = study.candidates[study.best];
    if (set.log_likelihood < best.log_likelihood - inference::kLeastEvidence) return false;
    const bool off = !plausible(law, best), set_off = !plausible(law, set);
    if (off && !set_off && set.effects.size() == best.effects.size() + 1 &&
        std::includes(set.effects.begin(), set.effects.end(), best.effects.begin(), best.effects.end()))
        return true;
    return set.effects.size() <= best.effects.size() && (set.refused.empty() || in_parts(law)) && (off || !set_off) &&
           needs_each(study, set);
}

/// More rows are explained, and only the parts of one file speak against it.
bool is_preferred(const Law& law, const Study& study, const Candidate& set) {
    const Candidate& best = study.candidates[study.best];
    return in_parts(law) && best.unseen_gap(0) > inference::kNearFloor * law.setup_floor && !set.refused.empty() && plausible(law, set) &&
           set.log_evidence >= best.log_evidence + inference::kLeastEvidence && needs_each(study, set);
}

/// Gives these sets `all` of the probability, by evidence, the first at most `most` of it.
void share(Study& study, const std::vector<std::size_t>& sets, double all, double most) {
    std::vector<double> evidence;
    for (const std::size_t i : sets) evidence.push_back(study.candidates[i].log_evidence);
    std::vector<double> shares = inference::probabilities(evidence);
    const auto top = std::max_element(shares.begin(), shares.end());
    if (const double others = 1.0 - *top; *top > most)
        for (double& s : shares)
            s = &s == &*top ? most : others > 0.0 ? s / others * (1.0 - most) : (1.0 - most) / static_cast<double>(sets.size() - 1);
    for (std::size_t i = 0; i < sets.size(); ++i) study.candidates[sets[i]].probability = all * shares[i];
}

/// Sets that explain fewer rows than another one lose: what parts of a file say of them is chance.
void weigh_by_evidence(Study& study) {
    double greatest = -std::numeric_limits<double>::infinity(), sum = 0.0;
    for (const Candidate& t : study.candidates)
        if (t.refused.empty()) greatest = std::max(greatest, t.log_evidence);
    for (Candidate& t : study.candidates) sum += t.probability *= std::exp(std::min(0.0, t.log_evidence - greatest));
    for (Candidate& t : study.candidates) t.probability /= sum;
    for (std::size_t i = 0; i < study.candidates.size(); ++i)
        if (study.candidates[i].probability > study.candidates[study.best].probability) study.best = i;
}

/// Effects that this case cannot show, alone, where they explain the rows better than the best set does: that one is no sure answer then.
void doubt(const Law& law, Study& study) {
    Candidate& best = study.candidates[study.best];
    if (best.unseen_gap(0) <= inference::kNearFloor * law.setup_floor) return;
    for (std::size_t e = 0; e < law.effects.size(); ++e) {
        if (law.effects[e].unseen.empty()) continue;
        Candidate hidden;
        hidden.effects = {e};
        fit_all(law, study, study.candidates.front().fit.values, hidden);
        set_evidence(law, study, hidden);
        if (hidden.log_evidence < best.log_evidence + inference::kLeastEvidence) continue;
        study.hidden = true;
        if (!best.effects.empty()) best.probability = std::min(best.probability, inference::kUnsureShare);
        study.remarks.push_back(fmt::format("{} would explain the rows better than {}: {:.3g} instead of {:.3g} {} are left in the fit",
                                            name_of(law.effects[e]), name_of(law, best.effects), hidden.seen_gap() * law.unit_sigma,
                                            best.seen_gap() * law.unit_sigma, law.unit));
    }
}

/// ", with sensor.torque_offset a.csv at 3 Nm": its nominal parameters that are not plausible.
std::string odd_values(const Law& law, const Candidate& set) {
    std::string text;
    for (std::size_t k = 0; k < law.nominal; ++k)
        if (const Parameter& p = law.parameters[k]; std::abs(prior_residual(p, set.fit.values[k])) > inference::kPlausible)
            text += fmt::format("{} {} at {:.3g} {}", text.empty() ? ", with" : " and", p.name, set.fit.values[k], p.unit);
    return text;
}

}  // namespace

void share_among_equals(const Law& law, Study& study) {
    if (!law.weighs_equals) return;
    weigh_by_evidence(study);
    doubt(law, study);
    std::vector<std::size_t> equal, preferred;
    for (std::size_t i = 0; i < study.candidates.size(); ++i) {
        const Candidate& set = study.candidates[i];
        if (i != study.best && (set.unseen.empty() || set.effects.size() > law.most_effects || at_end(law, set))) continue;
        if (i == study.best || is_equal(law, study, set))
            equal.push_back(i);
        else if (is_preferred(law, study, set))
            preferred.push_back(i);
    }
    if (equal.size() + preferred.size() < 2) return;
    double all = 0.0;
    for (const std::size_t i : equal) all += study.candidates[i].probability;
    const double kept = preferred.empty() ? all : all * inference::kUnsureShare;
    share(study, equal, kept, equal.size() > 1 ? inference::kUnsureShare : 1.0);
    if (!preferred.empty()) share(study, preferred, all - kept, 1.0);
    const auto probability = [&](std::size_t i) { return study.candidates[i].probability; };
    double most = 0.0;
    for (const std::size_t i : equal) most = std::max(most, probability(i));
    const auto first = std::find_if(equal.begin(), equal.end(), [&](std::size_t i) { return probability(i) >= inference::kTie * most; });
    study.best = *first;
    std::rotate(equal.begin(), first, first + 1);
    study.equals = equal;
    study.equals.insert(study.equals.end(), preferred.begin(), preferred.end());
}

std::vector<std::size_t> open_effects(const Study& study) {
    std::vector<std::size_t> open;
    if (study.equals.empty()) return open;
    std::size_t most = 0;
    for (const std::size_t i : study.equals)
        for (const std::size_t e : study.candidates[i].effects) most = std::max(most, e + 1);
    for (std::size_t e = 0; e < most; ++e) {
        const auto holders = std::count_if(study.equals.begin(), study.equals.end(), [&](std::size_t i) {
            const auto& of_set = study.candidates[i].effects;
            return std::find(of_set.begin(), of_set.end(), e) != of_set.end();
        });
        if (holders > 0 && static_cast<std::size_t>(holders) < study.equals.size()) open.push_back(e);
    }
    return open;
}

std::vector<std::string> equals_remarks(const Law& law, const Study& study) {
    std::vector<std::string> all;
    if (!study.equals.empty()) {
        std::vector<std::string> names;
        for (const std::size_t i : study.equals)
            names.push_back(name_of(law, study.candidates[i].effects) + odd_values(law, study.candidates[i]));
        all.push_back(fmt::format("equal in these rows, none of them is chosen: {}", fmt::join(names, "; ")));
    }
    const Candidate& best = study.candidates[study.best];
    if (!plausible(law, best)) all.push_back("not plausible: " + name_of(law, best.effects) + odd_values(law, best));
    return all;
}

}  // namespace fusee::subsystem
