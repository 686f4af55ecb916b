#include "data/json.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/figures.h"
#include "fusee/core/change.h"
#include "fusee/core/json.h"
#include "fusee/report/findings.h"
#include "fusee/report/rule_counts.h"

namespace fusee::report {

namespace {

/// The alternatives of a suggestion, each by key.
Json suggested_changes_json(const core::Suggestion& suggestion) {
    return json_list(suggestion.changes(), [](const core::Changes& changes) {
        Json one;
        for (const core::Change& change : changes) one[change.key] = change.value;
        return one;
    });
}

Json finding_json(const core::Finding& f) {
    Json j{{"rule", f.rule},
           {"severity", core::to_string(f.severity)},
           {"what", f.what},
           {"measured", f.measured},
           {"bound", f.bound == core::Bound::kAtMost ? "at most" : "at least"},
           {"allowed", f.allowed},
           {"unit", f.unit},
           {"where", f.where}};
    if (f.place) j["place"] = {{"angle_rad", f.place->angle}, {"point_mm", f.place->point_mm}};
    j["suggestion"] = f.suggestion.text();
    j["changes"] = suggested_changes_json(f.suggestion);
    j["source"] = f.source;
    for (const core::OverriddenLimit& o : f.overridden)
        j["overridden"].push_back({{"limit", o.limit}, {"value", o.value}, {"default", o.normal}, {"unit", o.unit}, {"reason", o.reason}});
    return j;
}

std::size_t& field_of(RuleCounts& counts, core::Severity severity) {
    switch (severity) {
        case core::Severity::kPass:
            return counts.passed;
        case core::Severity::kNotJudged:
            return counts.not_judged;
        case core::Severity::kWarning:
            return counts.review;
        case core::Severity::kError:
            break;
    }
    return counts.required;
}

}  // namespace

Json provenance_json(const core::Provenance& made_by) {
    return {{"fusee", core::version()}, {"name", made_by.name}, {"profile_sha256", made_by.profile_sha256}, {"options", made_by.options}};
}

Json range_json(const core::Range& range) { return Json::array({range.low, range.high}); }

Json findings_json(const core::Findings& findings) { return json_list(findings, finding_json); }

std::string findings_list_json(const core::Findings& findings) { return json_text(findings_json(findings)); }

Json rules_json(const core::Findings& findings) {
    const auto counts = [](std::size_t passed, std::size_t not_judged, std::size_t warnings, std::size_t errors) {
        return Json{{"passed", passed}, {"not_judged", not_judged}, {"warnings", warnings}, {"errors", errors}};
    };
    Json all = counts(core::count(findings, core::Severity::kPass), core::count(findings, core::Severity::kNotJudged),
                      core::count(findings, core::Severity::kWarning), core::count(findings, core::Severity::kError));
    all["groups"] = Json::object();
    for (const RuleCounts& group : count_rules(findings))
        all["groups"][group.group] = counts(group.passed, group.not_judged, group.review, group.required);
    return all;
}

std::string json_text(Json json, const RenamedFields& renamed) {
    core::keep_old_spelling(json, renamed);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<RuleCounts> count_rules(const core::Findings& findings) {
    std::vector<RuleCounts> all;
    for (const core::Finding& f : findings) {
        const std::string group = f.rule.substr(0, f.rule.find('.'));
        auto row = std::find_if(all.begin(), all.end(), [&](const RuleCounts& counts) { return counts.group == group; });
        if (row == all.end()) row = all.insert(all.end(), RuleCounts{group});
        ++field_of(*row, f.severity);
    }
    return all;
}

std::string not_judged_text(const core::Findings& findings) {
    const std::size_t number = core::count(findings, core::Severity::kNotJudged);
    if (number == 0) return "";
    std::vector<RuleCounts> groups = count_rules(findings);
    std::erase_if(groups, [](const RuleCounts& counts) { return counts.not_judged == 0; });
    std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.not_judged > b.not_judged; });
    std::string text = counted(number, "rule") + " not judged:";
    for (const RuleCounts& counts : groups)
        text += fmt::format("{} {} {}", &counts == &groups.front() ? "" : ",", counts.group, counts.not_judged);
    return text;
}

}  // namespace fusee::report
