#include "design/page.h"

#include "design/as_exported.h"
#include "fusee/report/assembly.h"
#include "fusee/report/budget.h"
#include "page/bundle.h"
#include "page/html.h"
#include "scene/scene.h"

namespace fusee::report {

namespace {

std::string design_verdict(core::Severity severity) {
    if (severity == core::Severity::kError) return "Must be changed";
    return severity == core::Severity::kWarning ? "Can be made once the warnings are accepted" : "Can be made";
}

Head design_head(const DesignReport& design) {
    const core::Findings findings = design.all_findings();
    const std::string not_judged = not_judged_text(findings);
    const core::Severity severity = verdict(design);
    const std::string open = not_judged.substr(0, not_judged.find(':'));
    Head head{"fusee design report",
              design.provenance.name,
              verdict_tag(severity, design_verdict(severity) + (open.empty() ? "" : "; " + open)),
              "",
              design.provenance.line(),
              {}};
    for (const HeadFigure& figure : head_figures(design.headline, design.file_errors()))
        head.tiles.emplace_back(figure.value, figure.label);
    const auto& samples = design.law.samples;
    if (!samples.empty())
        head.tiles.emplace_back(
            span({samples.front().tau, samples.back().tau}) + " Nm",
            design.law.covers_stiction() ? "loads of the law: all that stiction allows" : "loads of the law: not all that stiction allows");
    head.tiles.emplace_back(counted(core::count(findings, core::Severity::kError), "error") + ", " +
                                counted(core::count(findings, core::Severity::kWarning), "warning"),
                            "errors must be changed, warnings reviewed and accepted" + (not_judged.empty() ? "" : "; " + not_judged));
    return head;
}

}  // namespace

std::string report_html(const DesignReport& design) {
    const std::vector<NumberedFinding> findings = numbered(design);
    std::string body = joint_viewer_section(design, findings) + assembly_section(design);  // the joint follows the headline
    body += law_section(design) + dead_band_section(design) + table_section(design.law);
    if (design.headline.budget) body += budget_section(*design.headline.budget);
    body += findings_section(findings);
    for (const PartReport& part : design.parts) body += part_section(part, markers_of(findings, cam::to_string(part.part->cam.kind)));
    body += passed_section(findings) + read_back_section(design) + as_exported_section(design.as_exported) + files_section(design);
    return html_page(design.provenance.name, design_head(design), body, design.assembly ? joint_bundle() : "");
}

}  // namespace fusee::report
