#include "transfer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/inference/constants.h"
#include "verdicts.h"

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

}  // namespace

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

}  // namespace fusee::subsystem
