#include "html.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/core/text.h"

namespace fusee::python {

namespace {

std::string limit_of(const core::Finding& f) {
    if (std::isnan(f.measured)) return "";
    const std::string unit = f.unit.empty() ? "" : " " + f.unit;
    return fmt::format("{:.4g}{}, {} {:.4g}{}", f.measured, unit, f.bound == core::Bound::kAtMost ? "at most" : "at least", f.allowed,
                       unit);
}

std::string html_row(const std::vector<std::string>& cells, const char* tag) {
    std::string text = "<tr>";
    for (const std::string& cell : cells) text += fmt::format("<{0} style=\"text-align:left\">{1}</{0}>", tag, core::escape(cell));
    return text + "</tr>";
}

std::string findings_table(const core::Findings& findings) {
    std::string rows;
    for (const core::Severity severity : {core::Severity::kError, core::Severity::kWarning, core::Severity::kNotJudged})
        for (const core::Finding& f : findings)
            if (f.severity == severity)
                rows += html_row({core::to_string(f.severity), f.rule, f.what, limit_of(f), f.where, f.suggestion.text()}, "td");
    if (rows.empty()) return "";
    return "<table>" + html_row({"", "rule", "what", "measured", "where", "nearest change"}, "th") + rows + "</table>";
}

}  // namespace

std::string html_of(const std::string& heading, const std::vector<std::pair<std::string, std::string>>& figures,
                    const core::Findings& findings) {
    std::string text = "<div><b>" + core::escape(heading) + "</b><table>";
    for (const auto& [value, label] : figures) text += html_row({value, label}, "td");
    const std::string counts =
        fmt::format("{}, {}, {} passed, {} not judged", core::counted(core::count(findings, core::Severity::kError), "error"),
                    core::counted(core::count(findings, core::Severity::kWarning), "warning"), core::count(findings, core::Severity::kPass),
                    core::count(findings, core::Severity::kNotJudged));
    return text + "</table><div>" + (findings.empty() ? "" : counts) + "</div>" + findings_table(findings) + "</div>";
}

}  // namespace fusee::python
