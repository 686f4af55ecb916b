#include "json/json.h"

#include "fusee/core/change.h"
#include "fusee/report/rule_counts.h"

namespace fusee::report {

namespace {

/// The alternatives of a suggestion, each by key.
nlohmann::ordered_json changes_json(const std::string& suggestion) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const core::Changes& changes : core::suggested_changes(suggestion)) {
        nlohmann::ordered_json one;
        for (const core::Change& change : changes) one[change.key] = change.value;
        all.push_back(std::move(one));
    }
    return all;
}

}  // namespace

nlohmann::ordered_json findings_json(const core::Findings& findings) {
    using Json = nlohmann::ordered_json;
    Json all = Json::array();
    for (const core::Finding& f : findings) {
        Json j{{"rule", f.rule},
               {"severity", core::to_string(f.severity)},
               {"what", f.what},
               {"measured", f.measured},
               {"bound", f.bound == core::Bound::kAtMost ? "at most" : "at least"},
               {"allowed", f.allowed},
               {"unit", f.unit},
               {"where", f.where}};
        if (f.place) j["place"] = {{"angle_rad", f.place->angle}, {"point_mm", f.place->point_mm}};
        j["suggestion"] = f.suggestion;
        j["changes"] = changes_json(f.suggestion);
        j["source"] = f.source;
        for (const core::OverriddenLimit& o : f.overridden)
            j["overridden"].push_back(
                {{"limit", o.limit}, {"value", o.value}, {"default", o.normal}, {"unit", o.unit}, {"reason", o.reason}});
        all.push_back(std::move(j));
    }
    return all;
}

nlohmann::ordered_json rules_json(const core::Findings& findings) {
    using Json = nlohmann::ordered_json;
    const auto counts = [](std::size_t passed, std::size_t not_judged, std::size_t review, std::size_t required) {
        return Json{{"passed", passed}, {"not_judged", not_judged}, {"review", review}, {"required", required}};
    };
    Json all = counts(core::count(findings, core::Severity::kPass), core::count(findings, core::Severity::kNotJudged),
                      core::count(findings, core::Severity::kWarning), core::count(findings, core::Severity::kError));
    all["groups"] = Json::object();
    for (const RuleCounts& group : count_rules(findings))
        all["groups"][group.group] = counts(group.passed, group.not_judged, group.review, group.required);
    return all;
}

}  // namespace fusee::report
