#include "words.h"

#include <string>

#include "fusee/core/units.h"

namespace fusee::pipeline {

namespace {

/// A change of one of both cables in the keys of the profile of both.
core::Change of_both(core::Change change, const profile::OneSpring& law) {
    if (!law.pulls_back()) return change;
    if (change.key == "cam.spring.preload_mm") change.key = "cam.back.preload_mm";
    if (change.key == "law.to_deg") change = {"law.from_deg", core::number(-std::stod(change.value), 4)};
    return change;
}

/// The changes of one alternative; none if one of them has no key in the profile.
core::Changes changes_of(const profile::Profile& profile, const core::Alternative& alternative) {
    core::Changes changes;
    const auto& law = std::get<profile::OneSpring>(profile.law.curves);
    for (core::Change change : alternative.changes) {
        change.key = profile.in_its_words(change.key);
        if (change.key == "law.end_torque_Nm" && profile.places.contains("law.to_deg")) {
            const double first = law.pulls_back() ? -law.angles.high : law.angles.low;
            change = {"law.to_deg", core::number(core::deg_from_rad(first + std::stod(change.value)), 4)};
        }
        if (change.key.starts_with("law.") && change.key != "law.to_deg") return {};
        changes.push_back(of_both(std::move(change), law));
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
    const bool back = std::get<profile::OneSpring>(profile.law.curves).pulls_back();
    for (core::Finding& f : findings) {
        if (back && f.where.starts_with("k_pe")) f.where.insert(4, "_back");
        for (std::string* text : {&f.what, &f.where, &f.source}) *text = profile.in_its_words(*text);
        f.suggestion = translated(profile, f.suggestion);
        if (f.rule == "cam.arm" && f.suggestion.text().find("\"roller\"") != std::string::npos)
            f.suggestion.or_else("cam.family = \"two_cables\", one each way, each with its spring");
    }
    return findings;
}

}  // namespace fusee::pipeline
