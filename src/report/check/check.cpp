#include "fusee/report/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/provenance.h"
#include "fusee/report/rule_counts.h"
#include "json/json.h"

namespace fusee::report {

namespace {

using Json = nlohmann::ordered_json;

/// How far beyond its limit, as a share of it; what is not a number or may not be at all is farthest.
double beyond(const core::Finding& f) {
    if (!std::isfinite(f.measured) || f.allowed == 0.0) return INFINITY;
    return std::abs(f.measured - f.allowed) / std::abs(f.allowed);
}

std::string binding_text(const core::Findings& findings) {
    const core::Finding* f = binding(findings);
    if (f == nullptr) return "nothing binds";
    const std::string unit = f->unit.empty() ? "" : " " + f->unit;
    return fmt::format("{}: {:.4g}{}, allowed {} {:.4g}{}", f->rule, f->measured, unit,
                       f->bound == core::Bound::kAtMost ? "at most" : "at least", f->allowed, unit);
}

const char* verdict(const core::Findings& findings) { return core::any_error(findings) ? "cannot be made as it is" : "can be made"; }

std::string one(const Checked& checked, const CheckedProcess& p) {
    const core::Findings all = p.all();
    const std::string open = not_judged_text(all);
    std::string text = fmt::format("{} by {}: {}; {} required changes, {} to review, {} rules passed{}{}\n", checked.name, p.process,
                                   verdict(all), core::count(all, core::Severity::kError), core::count(all, core::Severity::kWarning),
                                   core::count(all, core::Severity::kPass), open.empty() ? "" : "; ", open);
    for (const core::Severity severity : {core::Severity::kError, core::Severity::kWarning, core::Severity::kNotJudged})
        for (const core::Finding& f : all)
            if (f.severity == severity) text += "    " + core::to_line(f) + "\n";
    return text + fmt::format("Limits: {}.\n", p.figures);
}

std::string table(const Checked& checked) {
    std::string text =
        fmt::format("{:8} {:10} {:>8} {:>6} {:>10}  {}\n", "process", "part", "required", "review", "not judged", "what binds");
    std::string notes;
    for (const CheckedProcess& p : checked.processes) {
        const std::string process = p.process + (p.own ? " *" : "");
        std::vector<CheckedPart> parts = p.parts;
        if (binding(p.about) != nullptr) parts.insert(parts.begin(), {"law", p.about});
        for (const CheckedPart& part : parts)
            text += fmt::format("{:8} {:10} {:>8} {:>6} {:>10}  {}\n", process, part.name,
                                core::count(part.findings, core::Severity::kError), core::count(part.findings, core::Severity::kWarning),
                                core::count(part.findings, core::Severity::kNotJudged), binding_text(part.findings));
        notes += fmt::format("{:8} {}\n", process, p.figures);
    }
    return text + "\nLimits:\n" + notes;
}

Json part_json(const CheckedPart& part) {
    Json j{{"part", part.name},
           {"required", core::count(part.findings, core::Severity::kError)},
           {"review", core::count(part.findings, core::Severity::kWarning)},
           {"not_judged", core::count(part.findings, core::Severity::kNotJudged)}};
    const core::Finding* f = binding(part.findings);
    j["binding"] = f == nullptr ? Json() : findings_json({*f}).front();
    j["findings"] = findings_json(part.findings);
    return j;
}

Json process_json(const CheckedProcess& p) {
    const core::Findings all = p.all();
    Json parts = Json::array();
    for (const CheckedPart& part : p.parts) parts.push_back(part_json(part));
    return {{"process", p.process},
            {"own", p.own},
            {"limits", p.figures},
            {"makeable", !core::any_error(all)},
            {"required", core::count(all, core::Severity::kError)},
            {"review", core::count(all, core::Severity::kWarning)},
            {"not_judged", core::count(all, core::Severity::kNotJudged)},
            {"rules", rules_json(all)},
            {"findings", findings_json(p.about)},
            {"parts", parts}};
}

}  // namespace

core::Findings CheckedProcess::all() const {
    core::Findings all = about;
    for (const CheckedPart& part : parts) core::append(all, part.findings);
    return all;
}

bool Checked::makeable() const {
    return std::any_of(processes.begin(), processes.end(), [](const CheckedProcess& p) { return !core::any_error(p.all()); });
}

const core::Finding* binding(const core::Findings& findings) {
    const core::Finding* found = nullptr;
    for (const core::Finding& f : findings) {
        if (!core::is_broken(f)) continue;
        const bool graver = !found || f.severity > found->severity || (f.severity == found->severity && beyond(f) > beyond(*found));
        if (graver) found = &f;
    }
    return found;
}

std::string check_text(const Checked& checked) {
    const std::string head = checked.input.empty() ? "" : checked.input + "\n";
    return head + (checked.processes.size() == 1 ? one(checked, checked.processes.front()) : table(checked));
}

std::string check_json(const Checked& checked) {
    Json processes = Json::array();
    for (const CheckedProcess& p : checked.processes) processes.push_back(process_json(p));
    const Json j{{"fusee", core::version()}, {"name", checked.name},           {"sha256", checked.sha256},
                 {"input", checked.input},   {"makeable", checked.makeable()}, {"processes", processes}};
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fusee::report
