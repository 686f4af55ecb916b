#include "fusee/report/check.h"

#include <fmt/format.h>

#include "data/figures.h"
#include "data/json.h"
#include "fusee/report/rule_counts.h"

namespace fusee::report {

namespace {

std::string binding_text(const core::Findings& findings) {
    const core::Finding* f = binding(findings);
    if (f == nullptr) return "none";
    const std::string unit = f->unit.empty() ? "" : " " + f->unit;
    return fmt::format("{}: {:.4g}{}, allowed {} {:.4g}{}", f->rule, f->measured, unit,
                       f->bound == core::Bound::kAtMost ? "at most" : "at least", f->allowed, unit);
}

/// "k_pe by fdm: cannot be made as it is: 2 errors (must be changed), 3 warnings (review and accept), 24 rules not judged: ..."
std::string one_process(const Checked& checked, const CheckedProcess& p) {
    const core::Findings all = p.all();
    const std::string not_judged = not_judged_text(all);
    std::string text = fmt::format("{} by {}: {}: {} (must be changed), {} (review and accept), {} passed{}{}\n", checked.name, p.process,
                                   core::any_error(all) ? "cannot be made as it is" : "can be made",
                                   counted(core::count(all, core::Severity::kError), "error"),
                                   counted(core::count(all, core::Severity::kWarning), "warning"),
                                   counted(core::count(all, core::Severity::kPass), "rule"), not_judged.empty() ? "" : ", ", not_judged);
    for (const core::Severity severity : {core::Severity::kError, core::Severity::kWarning, core::Severity::kNotJudged})
        for (const core::Finding& f : all)
            if (f.severity == severity) text += "    " + core::to_line(f) + "\n";
    return text + fmt::format("Limits: {}.\n", p.figures);
}

std::string process_table(const Checked& checked) {
    std::string text =
        fmt::format("{:8} {:10} {:>6} {:>8} {:>10}  {}\n", "process", "part", "errors", "warnings", "not judged", "binding rule");
    std::string notes;
    for (const CheckedProcess& p : checked.processes) {
        const std::string process = p.process + (p.own ? " *" : "");
        std::vector<CheckedPart> parts = p.parts;
        if (binding(p.about) != nullptr) parts.insert(parts.begin(), {checked.input.empty() ? "law" : "file", p.about});
        for (const CheckedPart& part : parts)
            text += fmt::format("{:8} {:10} {:>6} {:>8} {:>10}  {}\n", process, part.name,
                                core::count(part.findings, core::Severity::kError), core::count(part.findings, core::Severity::kWarning),
                                core::count(part.findings, core::Severity::kNotJudged), binding_text(part.findings));
        notes += fmt::format("{:8} {}\n", process, p.figures);
    }
    return text + "\nLimits:\n" + notes;
}

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

std::string check_text(const Checked& checked) {
    const std::string head = checked.input.empty() ? "" : checked.input + "\n";
    return head + (checked.processes.size() == 1 ? one_process(checked, checked.processes.front()) : process_table(checked));
}

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
