#include "remarks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fusee/inference/constants.h"

namespace fusee::subsystem {

namespace {

/// The last scheme that holds out whole files: by law, if several files have one.
const Scheme* scheme_of(const Law& law) {
    if (!law.each_fold || law.schemes.empty() || law.schemes.front().name != "file") return nullptr;
    return &law.schemes.back();
}

diagnosis::Transfer transfer_of(const Law& law, const Candidate& nominal, const Candidate& candidate, std::size_t s, std::size_t fold) {
    const std::vector<Fold> folds = folds_of(law.schemes[s]);
    const std::vector<std::size_t>& held = folds[fold].blocks;
    const std::vector<std::size_t> others = blocks_without(law, held);
    diagnosis::Transfer t;
    t.heldout = folds[fold].label;
    for (const Fold& other : folds)
        if (other.label != t.heldout) t.fitted += (t.fitted.empty() ? "" : ", ") + other.label;
    const Misfit before = misfit(law, nominal.refits[s][fold]), after = misfit(law, candidate.refits[s][fold]);
    const auto error = [&](const Misfit& m, const std::vector<std::size_t>& blocks) {
        return std::sqrt(m.mean_square(blocks)) * law.unit_sigma;
    };
    t.fit_before = error(before, others);
    t.fit_after = error(after, others);
    t.heldout_before = error(before, held);
    t.heldout_after = error(after, held);
    for (const std::size_t e : candidate.effects) {
        const std::size_t k = law.effects[e].parameters.front();
        t.effects.push_back(law.effects[e].cause);
        t.parameters.push_back({candidate.refits[s][fold][k], {}, law.parameters[k].unit});
    }
    t.unit = law.unit;
    return t;
}

bool is_false(const diagnosis::Transfer& t) {
    return t.fit_after < t.fit_before && t.heldout_after > inference::kRaised * t.heldout_before;
}

std::string sizes_of(const diagnosis::Transfer& t) {
    std::string out;
    for (const diagnosis::Parameter& p : t.parameters)
        out += fmt::format("{}{:.3g}{}{}", out.empty() ? "" : ", ", p.value, p.unit.empty() ? "" : " ", p.unit);
    return out;
}

bool holds(const std::vector<effects::Cause>& causes, const effects::Cause& cause) {
    return std::find(causes.begin(), causes.end(), cause) != causes.end();
}

/// @param answer the effects of the answer: one that needs the others beside it is no false cause
std::string sentence(const Law& law, const std::vector<diagnosis::Transfer>& folds, const std::vector<effects::Cause>& answer) {
    std::vector<std::size_t> effects;
    for (std::size_t e = 0; e < law.effects.size(); ++e)
        if (holds(folds.front().effects, law.effects[e].cause)) effects.push_back(e);
    const auto refuted = std::find_if(folds.begin(), folds.end(), is_false);
    if (refuted != folds.end() && !holds(answer, folds.front().effects.front()))
        return fmt::format(
            "{} is a false cause: fitted to {} ({}) it lowers the error there from {:.3g} to {:.3g} {} and raises it on {}, held out, from "
            "{:.3g} to {:.3g} {}",
            name_of(law, effects), refuted->fitted, sizes_of(*refuted), refuted->fit_before, refuted->fit_after, law.unit, refuted->heldout,
            refuted->heldout_before, refuted->heldout_after, law.unit);
    std::string out = name_of(law, effects) + (effects.size() > 1 ? " from the other files:" : " alone, from the other files:");
    for (const diagnosis::Transfer& t : folds)
        out += fmt::format(" {}, held out, from {:.3g} to {:.3g} {} ({});", t.heldout, t.heldout_before, t.heldout_after, law.unit,
                           sizes_of(t));
    out.pop_back();
    return out;
}

/// What each effect alone and the answer, fitted on the other files, do on each held-out file (each law's files, if several have one law).
/// Empty unless Law::each_fold, and with one file. @pre the study is judged
std::vector<diagnosis::Transfer> transfers_of(const Law& law, const Study& study) {
    const Scheme* const scheme = scheme_of(law);
    std::vector<diagnosis::Transfer> all;
    if (scheme == nullptr) return all;
    const auto s = static_cast<std::size_t>(scheme - law.schemes.data());
    for (std::size_t i = 1; i < study.candidates.size(); ++i) {
        const Candidate& candidate = study.candidates[i];
        if ((candidate.effects.size() > 1 && i != study.best) || candidate.refits.empty()) continue;
        for (std::size_t fold = 0; fold < candidate.refits[s].size(); ++fold)
            all.push_back(transfer_of(law, study.candidates.front(), candidate, s, fold));
    }
    return all;
}

/// One sentence for each set of effects that `transfer` holds: false causes, then those of the answer, then the others.
std::vector<std::string> transfer_remarks(const Law& law, const std::vector<diagnosis::Transfer>& transfer,
                                          const std::vector<effects::Cause>& answer) {
    std::vector<std::string> refuted, others;
    std::vector<std::pair<std::size_t, std::string>> named;
    for (std::size_t begin = 0, end = 0; begin < transfer.size(); begin = end) {
        while (end < transfer.size() && transfer[end].effects == transfer[begin].effects) ++end;
        const std::vector<diagnosis::Transfer> folds(transfer.begin() + static_cast<std::ptrdiff_t>(begin),
                                                     transfer.begin() + static_cast<std::ptrdiff_t>(end));
        std::string text = sentence(law, folds, answer);
        if (holds(answer, folds.front().effects.front()))
            named.emplace_back(folds.front().effects.size(), std::move(text));
        else
            (std::any_of(folds.begin(), folds.end(), is_false) ? refuted : others).push_back(std::move(text));
    }
    std::stable_sort(named.begin(), named.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });  // the answer itself first
    for (auto& [effects, text] : named) refuted.push_back(std::move(text));
    refuted.insert(refuted.end(), others.begin(), others.end());
    return refuted;
}

/// Where most of what the answer leaves lies, if that is above the floor.
void put_rest_remark(const Law& law, diagnosis::Diagnosis& out) {
    const auto most = std::max_element(out.map.begin(), out.map.end(), [](const diagnosis::GapCell& a, const diagnosis::GapCell& b) {
        return a.after * a.after * static_cast<double>(a.rows) < b.after * b.after * static_cast<double>(b.rows);
    });
    if (!law.each_fold || most == out.map.end() || out.gap.heldout_after <= inference::kNearFloor * law.setup_floor) return;
    out.remarks.push_back(
        fmt::format("what remains: {:.3g} {} in the fit and {:.3g} {} on held-out rows (root mean square), most of it in {} at {} {:.3g} "
                    "to {:.3g}: {:.3g} {} there",
                    out.gap.after * law.unit_sigma, law.unit, out.gap.heldout_after * law.unit_sigma, law.unit, most->experiment,
                    most->variable, most->region.low, most->region.high, most->after * law.unit_sigma, law.unit));
}

void put_floor_remarks(const Law& law, const Study& study, diagnosis::Diagnosis& out) {
    const Candidate& best = study.candidates[study.best];
    const double kept = best.unseen_gap(0), unit = law.unit_sigma;
    if (kept <= inference::kNearFloor * law.setup_floor)
        out.remarks.push_back(
            fmt::format("at the floor: the held-out error is {:.4g} {}, and {:.4g} {} is the difference between {}: no gap is left "
                        "to explain",
                        kept * unit, law.unit, law.setup_floor * unit, law.unit,
                        law.setup_floor > law.cycle_floor ? "set-ups of the same motion" : "repeats"));
    else
        out.remarks.push_back(
            fmt::format("above the floor: the held-out error is {:.4g} {}, the floor {:.4g} {}: no known cause explains part of the gap",
                        kept * unit, law.unit, law.setup_floor * unit, law.unit));
}

void put_split_remarks(const Law& law, const Study& study, diagnosis::Diagnosis& out) {
    const Candidate& best = study.candidates[study.best];
    const double unit = law.unit_sigma;
    for (std::size_t s = 0; s < law.schemes.size(); ++s)
        out.remarks.push_back(fmt::format("held out by {}: {:.4g} {} before, {:.4g} {} after", law.schemes[s].name,
                                          study.candidates.front().unseen_gap(s) * unit, law.unit, best.unseen_gap(s) * unit, law.unit));
}

/// Which choice of the open input was taken, and how far ahead it is.
void put_choice_remark(const Law& law, const Study& study, diagnosis::Diagnosis& out) {
    if (!law.open_input) return;
    std::vector<const char*> others;
    for (std::size_t c = 0; c < law.open_input->choices.size(); ++c)
        if (c != study.choice) others.push_back(law.open_input->choices[c].second);
    out.remarks.push_back(fmt::format("{} is not given: {} is taken, tried beside {} and ahead by {:.1f} nats{}", law.open_input->key,
                                      law.open_input->choices[study.choice].second, fmt::join(others, " and "), study.choice_lead,
                                      study.choice_lead < inference::kDisagreement ? "; the rows hardly distinguish them" : ""));
}

}  // namespace

std::vector<effects::Cause> causes_of(const Law& law, const Candidate& candidate) {
    std::vector<effects::Cause> causes;
    for (const std::size_t e : candidate.effects) causes.push_back(law.effects[e].cause);
    return causes;
}

void put_remarks(const Law& law, const Study& study, diagnosis::Diagnosis& out) {
    put_choice_remark(law, study, out);
    const std::vector<std::string> equals = equals_remarks(law, study);
    out.remarks.insert(out.remarks.end(), equals.begin(), equals.end());
    put_rest_remark(law, out);
    out.transfer = transfers_of(law, study);
    const std::vector<std::string> transfer = transfer_remarks(law, out.transfer, causes_of(law, study.candidates[study.best]));
    out.remarks.insert(out.remarks.end(), transfer.begin(), transfer.end());
    put_floor_remarks(law, study, out);
    put_split_remarks(law, study, out);
    for (const auto& more : {study.remarks, law.remarks(), law.floor_remarks})
        out.remarks.insert(out.remarks.end(), more.begin(), more.end());
}

}  // namespace fusee::subsystem
