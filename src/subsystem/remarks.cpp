#include "remarks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "equals.h"
#include "fusee/inference/constants.h"
#include "transfer.h"

namespace fusee::subsystem {

namespace {

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
