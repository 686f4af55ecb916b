#include "design/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "design/as_exported.h"
#include "page/html.h"

namespace fusee::report {

namespace {

/// What was decided, and what was not judged.
std::string verdict_text(core::Severity severity, const std::string& not_judged) {
    const std::string open = not_judged.empty() ? "" : "; " + escape(not_judged.substr(0, not_judged.find(':')));
    switch (severity) {
        case core::Severity::kPass:
        case core::Severity::kNotJudged:
            return fmt::format("<span class=\"verdict {}\">\u2713 Can be made{}</span>", open.empty() ? "pass-tag" : "unjudged-tag", open);
        case core::Severity::kWarning:
            return "<span class=\"verdict review-tag\">! Review and accept" + open + "</span>";
        case core::Severity::kError:
            return "<span class=\"verdict required-tag\">\u2715 Change required" + open + "</span>";
    }
    return "";
}

std::string findings_text(const core::Findings& findings) {
    return fmt::format("{} / {} / {}", core::count(findings, core::Severity::kError), core::count(findings, core::Severity::kWarning),
                       core::count(findings, core::Severity::kNotJudged));
}

}  // namespace

std::string head_section(const DesignReport& design) {
    const core::Provenance& made_by = design.provenance;
    const core::Findings findings = design.all_findings();
    const std::string not_judged = not_judged_text(findings);
    std::string out = "<header><p class=\"eyebrow\">fusee design report</p><h1>" + escape(made_by.name) + "</h1>" +
                      verdict_text(verdict(design), not_judged) + "<p class=\"stamp\">" + escape(made_by.line()) +
                      "</p><div class=\"tiles\">";
    for (const HeadFigure& figure : head_figures(design.outlook, design.file_errors())) out += html_tile(figure.value, figure.label);
    if (!design.law.samples.empty())
        out += html_tile(number(design.law.samples.front().tau, 3) + " to " + number(design.law.samples.back().tau, 3) + " Nm",
                         design.law.covers_stiction() ? "loads, all that stiction allows" : "loads, stiction not covered");
    const std::string label = "changes required / to review / not judged";
    return out + html_tile(findings_text(findings), not_judged.empty() ? label : label + not_judged.substr(not_judged.find(':'))) +
           "</div></header>\n";
}

std::string report_html(const DesignReport& design) {
    const std::vector<NumberedFinding> findings = numbered(design);
    std::string body = head_section(design);
    for (const PartReport& part : design.parts) body += part_section(part, markers_of(findings, cam::to_string(part.part->cam.kind)));
    body += findings_section(findings) + law_section(design) + table_section(design.law) + dead_band_section(design) +
            read_back_section(design) + as_exported_section(design.as_exported) + files_section(design);
    return html_page(design.provenance.name, body);
}

}  // namespace fusee::report
