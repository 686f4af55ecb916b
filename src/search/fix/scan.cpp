#include "scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/parallel.h"
#include "standard.h"

namespace fusee::search::fix {

namespace {

using Steps = std::vector<core::Changes>;

constexpr int kSpringSteps = 32;        // each way, by factors that grow from 1.2 to 1e15: a rate may be wrong by its unit
constexpr double kLeastPreload = 0.05;  // [rad, mm] from which an unloaded spring is loaded
constexpr int kBothSteps = 3;           // each way of rate and preload together
constexpr double kBothFactor = 1.3;     // of each such step
constexpr int kLawSteps = 24;           // from the whole law to one that ends at
constexpr double kWorthwhile = 1.2;     // times its start: a shorter law is useless
constexpr double kLeadInFactor = 0.7;   // of each step of a shorter lead-in
constexpr int kLeadInSteps = 12;        // down to 1 %

double factor(int step) { return std::exp(std::copysign(0.15 * std::abs(step) + 0.03 * step * step, step)); }

core::Change change(const std::string& key, double value) { return {key, fmt::format("{:.4g}", value)}; }

double value_of(const profile::Profile& draft, const std::string& key) { return *number_in(*profile::value_text(draft, key)); }

/// Nearest first, up and down.
Steps one_key(const profile::Profile& draft, const std::string& key) {
    const double now = value_of(draft, key);
    Steps steps;
    for (int i = 1; i <= kSpringSteps; ++i) {
        if (now > 0.0)
            for (const int way : {i, -i}) steps.push_back({change(key, now * factor(way))});
        else
            steps.push_back({change(key, kLeastPreload * factor(i - 1))});
    }
    return steps;
}

Steps two_keys(const profile::Profile& draft, const std::string& rate, const std::string& preload) {
    std::vector<std::pair<int, int>> pairs;
    for (int i = -kBothSteps; i <= kBothSteps; ++i)
        for (int j = -kBothSteps; j <= kBothSteps; ++j)
            if (i != 0 && j != 0) pairs.emplace_back(i, j);
    std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
        return std::abs(a.first) + std::abs(a.second) < std::abs(b.first) + std::abs(b.second);
    });
    Steps steps;
    for (const auto& [i, j] : pairs)
        steps.push_back({change(rate, value_of(draft, rate) * std::pow(kBothFactor, i)),
                         change(preload, value_of(draft, preload) * std::pow(kBothFactor, j))});
    return steps;
}

/// The choices that law and cams depend on, as a text; changes of a body alone are left out.
std::string seen_by_cams(const Choices& choices) {
    std::string text;
    for (const auto& [key, choice] : choices)
        if (key.starts_with("law.") || key.starts_with("cable.") || key.find(".spring.") != key.npos || key.find(".path.") != key.npos ||
            key.find(".guide.") != key.npos)
            text += key + "=" + choice.value + "\n";
    return text;
}

/// The rates alone: the other figures of a catalogue spring follow.
Steps rates_of(const Steps& springs) {
    Steps steps;
    for (const core::Changes& spring : springs) steps.push_back({spring.front()});
    return steps;
}

bool sound(const Verdict& verdict) {
    return verdict.unseen == 0 && std::none_of(verdict.broken.begin(), verdict.broken.end(), [](const core::Finding& f) {
               return f.rule.starts_with("law.") || f.rule.starts_with("cam.");
           });
}

}  // namespace

bool Scan::walk(const Steps& steps, const Choices& choices, const Look& look, std::vector<Step>& found) const {
    struct Looked {
        Held held;
        bool judged = false;
        std::optional<Verdict> verdict;
    };
    constexpr std::size_t kAtOnce = 8;  // on all processors; those behind the last one needed are forgotten
    std::optional<Step> first_sound, best;
    const auto as_it_is = drafts_.read(choices);
    const int before = look(*as_it_is).left();
    judge_.count();
    std::vector<Looked> block;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (i % kAtOnce == 0) {
            block.assign(std::min(kAtOnce, steps.size() - i), {});
            core::parallel_for(block.size(), jobs_, [&](std::size_t k) {
                Looked& one = block[k];
                one.held = hold(steps[i + k], *as_it_is, drafts_);
                if (one.held.changes.empty()) return;
                const auto profile = drafts_.read(drafts_.with(choices, one.held.changes, {}, 0, one.held.follows));
                one.judged = profile.has_value();
                if (profile) one.verdict = if_allowed([&] { return look(*profile); });
            });
        }
        const auto& [held, judged, verdict] = block[i % kAtOnce];
        if (judged) judge_.count();
        if (!verdict) continue;
        if (!first_sound && sound(*verdict)) first_sound = Step{held.changes, held.follows, verdict->left()};
        if (!best || verdict->left() < best->left) best = Step{held.changes, held.follows, verdict->left()};
        if (best->left == 0) break;
    }
    if (first_sound && first_sound->left < before) found.push_back(*first_sound);
    if (best && best->left < (first_sound ? std::min(first_sound->left, before) : before)) found.push_back(*best);
    return best && best->left == 0;
}

const std::vector<Scan::Step>& Scan::springs(cam::PartKind part, const profile::Profile& draft, const Choices& choices) {
    const auto [at, is_new] = known_.try_emplace(to_string(part) + ("\n" + seen_by_cams(choices)));
    if (is_new) at->second = scan_springs(part, draft, choices);
    return at->second;
}

const std::vector<Scan::Step>& Scan::laws(const profile::Profile& draft, const Choices& choices) {
    const auto [at, is_new] = known_.try_emplace("law\n" + seen_by_cams(choices));
    if (is_new) at->second = scan_laws(draft, choices);
    return at->second;
}

std::vector<Scan::Step> Scan::scan_springs(cam::PartKind part, const profile::Profile& draft, const Choices& choices) {
    const bool torsion = part == cam::PartKind::kSeries;
    const std::string table = draft.table_of(part), spring = table + ".spring.",
                      rate = spring + (torsion ? "rate_Nm_per_rad" : "rate_N_per_m"),
                      preload = spring + (torsion ? "preload_rad" : "preload_mm");
    const Look look = [&](const profile::Profile& profile) { return judge_.seen(profile, std::span(&part, 1)); };
    std::vector<Step> found;
    const std::vector<core::Changes> sold = catalogue_springs(table, draft);
    const bool by_preload = walk(one_key(draft, preload), choices, look, found),
               by_rate = walk(sold.empty() ? one_key(draft, rate) : rates_of(sold), choices, look, found);
    if (!by_preload && !by_rate && value_of(draft, preload) > 0.0) walk(two_keys(draft, rate, preload), choices, look, found);
    return found;
}

std::vector<Scan::Step> Scan::scan_laws(const profile::Profile& draft, const Choices& choices) {
    const double start = draft.law.start_torque, end = draft.law.end_torque, shortest = kWorthwhile * start / end;
    const Look look = [&](const profile::Profile& profile) { return judge_.seen(profile); };
    Steps ends, starts, lead_ins;
    std::vector<Step> found;
    for (int i = 1; i <= kLawSteps && shortest > 0.0 && shortest < 1.0; ++i) {
        const double share = std::pow(shortest, static_cast<double>(i) / kLawSteps);
        ends.push_back({change("law.end_torque_Nm", end * share)});
        starts.push_back({change("law.start_torque_Nm", start / share)});
    }
    if (profile::value_text(draft, "law.lead_in_deg") && draft.law.lead_in_travel > 0.0)
        for (int i = 1; i <= kLeadInSteps; ++i)
            lead_ins.push_back({change("law.lead_in_deg", value_of(draft, "law.lead_in_deg") * std::pow(kLeadInFactor, i))});
    for (const Steps& steps : {lead_ins, ends, starts})
        if (!steps.empty() && profile::value_text(draft, steps.front().front().key)) walk(steps, choices, look, found);
    return found;
}

}  // namespace fusee::search::fix
