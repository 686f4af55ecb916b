#include "words.h"

#include <string>

#include "fusee/core/units.h"

namespace fusee::pipeline {

namespace {

/// The changes of one alternative; none if one of them has no key in the profile.
core::Changes changes_of(const profile::Profile& profile, const core::Alternative& alternative) {
    core::Changes changes;
    for (core::Change change : alternative.changes) {
        change.key = profile.in_its_words(change.key);
        if (change.key == "law.end_torque_Nm" && profile.places.contains("law.to_deg")) {
            const double angle = std::get<profile::OneSpring>(profile.law.curves).angles.low + std::stod(change.value);
            change = {"law.to_deg", core::number(core::deg_from_rad(angle), 4)};
        }
        if (change.key.starts_with("law.") && change.key != "law.to_deg") return {};
        changes.push_back(std::move(change));
    }
    return changes;
}

core::Suggestion translated(const profile::Profile& profile, const core::Suggestion& suggestion) {
    core::Suggestion all;
    for (const core::Alternative& one : suggestion.alternatives()) {
        const core::Changes changes = changes_of(profile, one);
        if (changes.empty() && !one.changes.empty()) continue;
        core::Suggestion next =
            changes.empty() ? core::Suggestion(profile.in_its_words(one.before)) : core::change(changes.front().key, changes.front().value);
        for (std::size_t i = 1; i < changes.size(); ++i) next.with(changes[i].key, changes[i].value);
        if (!changes.empty() && !one.before.empty()) next.begun(profile.in_its_words(one.before));
        if (!one.after.empty()) next.noted(profile.in_its_words(one.after));
        all = all.empty() ? next : all.or_else(next);
    }
    return all;
}

}  // namespace

core::Findings in_words_of(const profile::Profile& profile, core::Findings findings) {
    if (!profile.is_spring()) return findings;
    for (core::Finding& f : findings) {
        for (std::string* text : {&f.what, &f.where, &f.source}) *text = profile.in_its_words(*text);
        f.suggestion = translated(profile, f.suggestion);
    }
    return findings;
}

}  // namespace fusee::pipeline
