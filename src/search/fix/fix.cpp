#include "fusee/search/fix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/actuator/dead_band.h"
#include "fusee/pipeline/design.h"
#include "search.h"
#include "standard.h"

namespace fusee::search::fix {

namespace {

/// A profile that can be made, as near to the original as its choices allow.
struct Nearest {
    Choices choices;
    std::map<std::string, core::Finding> binds;  ///< by key of the law: the finding against a nearer value
};

constexpr int kHalvings = 12;

class Narrowing {
public:
    Narrowing(const Drafts& drafts, Judge& judge, Choices found) : drafts_(drafts), judge_(judge), result_{std::move(found), {}} {}

    /// Files are made once, of the end. Where one of them breaks a limit that the solids keep, every step is made with its files.
    Nearest run() {
        const Choices found = result_.choices;
        narrow();
        if (!narrowed_ || holds(result_.choices, true)) return std::move(result_);
        result_ = {found, {}};
        each_with_files_ = true;
        narrow();
        return std::move(result_);
    }

private:
    void narrow() {
        undo_needless();
        std::set<int> moves;
        for (const auto& [key, choice] : result_.choices) moves.insert(choice.move);
        for (const int move : moves)
            if (graded(move)) halve(move);
    }

    void take(Choices choices) {
        result_.choices = std::move(choices);
        narrowed_ = true;
    }

    [[nodiscard]] std::optional<Verdict> drawn(const Choices& choices) {
        const auto profile = drafts_.read(choices);
        return profile ? if_allowed([&] { return judge_.drawing(*profile); }) : std::nullopt;
    }
    [[nodiscard]] bool holds(const Choices& choices, bool with_files) {
        const auto profile = drafts_.read(choices);
        const auto judged = [&] { return with_files ? judge_.all(*profile) : judge_.unwritten(*profile); };
        const auto verdict = profile ? if_allowed(judged) : std::nullopt;
        return verdict && verdict->clear();
    }

    /// Highest weight first.
    void undo_needless() {
        std::vector<std::string> keys;
        for (const auto& [key, choice] : result_.choices) keys.push_back(key);
        std::stable_sort(keys.begin(), keys.end(),
                         [](const std::string& a, const std::string& b) { return policy_of(a)->weight > policy_of(b)->weight; });
        for (bool undone = true; undone;) {
            undone = false;
            for (const std::string& key : keys) {
                const auto choice = result_.choices.find(key);
                if (choice == result_.choices.end() || !choice->second.follows.empty()) continue;
                Choices without = result_.choices;
                std::erase_if(without, [&key](const auto& entry) { return entry.first == key || entry.second.follows == key; });
                if (without.empty() || !holds(without, each_with_files_)) continue;
                take(std::move(without));
                undone = true;
            }
        }
    }

    /// A spring whose coils did not fit its rate fits it, and does not go back to where its difference is just allowed.
    [[nodiscard]] bool graded(int move) const {
        return std::all_of(result_.choices.begin(), result_.choices.end(), [&](const auto& entry) {
            const auto& [key, choice] = entry;
            return choice.move != move || (choice.because.rule != "spring.rate" && policy_of(key)->graded && number_in(choice.value) &&
                                           number_in(drafts_.was(key)));
        });
    }

    /// The choices with those of one move at a share of their way, in even steps of the logarithm if there is one.
    [[nodiscard]] Choices part_way(int move, double share) const {
        Choices choices = result_.choices;
        for (auto& [key, choice] : choices) {
            if (choice.move != move) continue;
            const double from = *number_in(drafts_.was(key)), to = *number_in(choice.value);
            const double value = from > 0.0 && to > 0.0 ? from * std::pow(to / from, share) : from + (to - from) * share;
            choice.value = fmt::format("{:.4g}", value);
        }
        settle(choices, move);
        return choices;
    }

    /// Turns that follow a rate are those of the rate on its way, and not a share of the way to the last ones.
    void settle(Choices& choices, int move) const {
        const auto draft = drafts_.read(choices);
        for (auto& [key, choice] : choices) {
            if (!draft || choice.move != move || choice.follows.empty()) continue;
            if (const auto value = settled_follower(key, *draft)) choice.value = fmt::format("{:.6g}", *value);
        }
    }

    void halve(int move) {
        double good = 1.0, bad = 0.0;
        core::Finding binding;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = 0.5 * (good + bad);
            const auto verdict = drawn(part_way(move, middle));
            (verdict && verdict->clear() ? good : bad) = middle;
            if (verdict && !verdict->clear()) binding = verdict->broken.front();
        }
        const Choices nearer = part_way(move, good);
        if (good == 1.0 || !holds(nearer, each_with_files_)) return;  // a rule that needs the solid or a file objects
        take(nearer);
        for (const auto& [key, choice] : result_.choices)
            if (choice.move == move && !binding.rule.empty()) result_.binds[key] = binding;
    }

    const Drafts& drafts_;
    Judge& judge_;
    Nearest result_;
    bool narrowed_ = false, each_with_files_ = false;
};

/// Undoes each choice that is not needed with the others, then moves law and base springs back by halves while every limit holds; the
/// changes of one suggestion move together. @pre `found` is made with every file, and judged last by `judge`
Nearest undo_needless(const Drafts& drafts, Judge& judge, Choices found) { return Narrowing(drafts, judge, std::move(found)).run(); }

/// Exact dead-band at peak torque [rad]; none of a single spring, or if no law exists or if it does not reach that far.
std::optional<double> dead_band_of(const profile::Profile& profile) {
    if (profile.is_spring()) return std::nullopt;
    const auto design = if_allowed([&] { return pipeline::resolve(profile); });
    if (!design || !*design) return std::nullopt;
    const actuator::DeadBand band = actuator::dead_band((*design)->actuator, profile.rig.peak_torque);
    return band.covered ? std::optional(band.exact_width) : std::nullopt;
}

std::vector<MadeChange> changes_made(const Drafts& drafts, const Choices& choices) {
    std::vector<MadeChange> changes;
    for (const auto& [key, choice] : choices)
        changes.push_back({{key, choice.value, drafts.was(key)}, policy_of(key)->asks_for, choice.because, choice.follows});
    return changes;
}

/// Loads that the law lost.
std::vector<LostTorque> lost(const Drafts& drafts, const Nearest& nearest) {
    std::vector<LostTorque> all;
    for (const auto& [key, choice] : nearest.choices) {
        if (key != "law.start_torque_Nm" && key != "law.end_torque_Nm") continue;
        const double from = *number_in(drafts.was(key)), to = *number_in(choice.value);
        if ((key == "law.end_torque_Nm") != (to < from)) continue;
        const auto binds = nearest.binds.find(key);
        all.push_back({key, from, to, binds == nearest.binds.end() ? choice.because : binds->second});
    }
    return all;
}

}  // namespace

Fix find_fix(const profile::Profile& profile, const std::string& toml, const FixOptions& options) {
    pipeline::require_parts(profile);
    pipeline::require_one_cable(profile, "changes of a profile");
    for (const std::string& key : options.keep) profile::require_key("--keep", key);
    const Drafts drafts(profile, toml, options.file, options.keep);
    Judge judge(options);
    (void)judge.drawing(profile);  // here inconsistent values are the caller's mistake; in a draft they are not
    Searched searched = Search(drafts, judge, options).run();
    Fix fix;
    fix.profile_name = profile.name;
    fix.peak_torque = profile.rig.peak_torque;
    fix.band_before = dead_band_of(profile);
    Nearest nearest{searched.choices, {}};
    if (searched.found && !searched.choices.empty()) nearest = undo_needless(drafts, judge, searched.choices);
    fix.changes = changes_made(drafts, nearest.choices);
    fix.judged = judge.judged();
    fix.made = judge.made();
    fix.circles.assign(searched.circles.begin(), searched.circles.end());
    for (const auto& [key, why] : searched.refused) fix.unchanged.push_back(fmt::format("{}: {}", key, why));
    if (!searched.found) {
        fix.ended = searched.ended;
        fix.left = std::move(searched.left);
        fix.conflicts = std::move(searched.conflicts);
        return fix;
    }
    fix.lost = lost(drafts, nearest);
    fix.end = fix.changes.empty() ? Fix::End::kNothingToDo : fix.lost.empty() ? Fix::End::kFixed : Fix::End::kShortened;
    fix.left = judge.warnings();
    fix.not_judged = judge.not_judged();
    fix.band_after = dead_band_of(*drafts.read(nearest.choices));
    if (fix.changes.empty()) return fix;
    fix.file = options.file;
    fix.toml = drafts.text(nearest.choices);
    return fix;
}

}  // namespace fusee::search::fix
