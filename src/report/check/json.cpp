#include "data/json.h"

#include "fusee/report/check.h"

namespace fusee::report {

namespace {

/// Numbers of errors, warnings and rules not judged.
void add_counts(Json& json, const core::Findings& findings) {
    json["errors"] = core::count(findings, core::Severity::kError);
    json["warnings"] = core::count(findings, core::Severity::kWarning);
    json["not_judged"] = core::count(findings, core::Severity::kNotJudged);
}

Json checked_part_json(const CheckedPart& part) {
    Json j{{"part", part.name}};
    add_counts(j, part.findings);
    const core::Finding* f = binding(part.findings);
    j["binding"] = f == nullptr ? Json() : findings_json({*f}).front();
    j["findings"] = findings_json(part.findings);
    return j;
}

Json process_json(const CheckedProcess& p) {
    const core::Findings all = p.all();
    Json j{{"process", p.process}, {"own", p.own}, {"limits", p.figures}, {"makeable", !core::any_error(all)}};
    add_counts(j, all);
    j["rules"] = rules_json(all);
    j["findings"] = findings_json(p.about);
    j["parts"] = json_list(p.parts, checked_part_json);
    return j;
}

}  // namespace

std::string check_json(const Checked& checked) {
    return json_text({{"fusee", core::version()},
                      {"name", checked.name},
                      {"sha256", checked.sha256},
                      {"input", checked.input},
                      {"makeable", checked.makeable()},
                      {"processes", json_list(checked.processes, process_json)}},
                     kRenamedCounts);
}

}  // namespace fusee::report
