#include "fusee/search/fix.h"

#include <fmt/format.h>

#include <algorithm>

#include "fusee/actuator/dead_band.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/edit.h"
#include "nearest.h"
#include "policy.h"
#include "search.h"

namespace fusee::search::fix {

namespace {

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
