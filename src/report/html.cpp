#include "html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "as_exported_page.h"
#include "page.h"

namespace fusee::report {

namespace {

std::string verdict_text(core::Severity severity) {
    switch (severity) {
        case core::Severity::kPass:
            return "<span class=\"verdict pass-tag\">\u2713 Can be made</span>";
        case core::Severity::kNotJudged:
            return "<span class=\"verdict pass-tag\">\u2713 Can be made, as far as it was judged</span>";
        case core::Severity::kReview:
            return "<span class=\"verdict review-tag\">! Review and accept</span>";
        case core::Severity::kRequired:
            return "<span class=\"verdict required-tag\">\u2715 Change required</span>";
    }
    return "";
}

/// The worst arm error of all files; NaN if none was read back.
double worst_arm_error(const DesignReport& design) {
    double worst = std::numeric_limits<double>::quiet_NaN();
    for (const readback::ArmError* e : design.arm_errors())
        if (e->when_broken == core::Severity::kRequired) worst = std::fmax(worst, e->worst_relative);
    return worst;
}

/// The lowest and the highest co-contraction for which the springs reach far enough; the whole range if none.
std::pair<actuator::DeadBand, actuator::DeadBand> exact_ends(const std::vector<actuator::DeadBand>& band) {
    const auto known = [](const actuator::DeadBand& d) { return std::isfinite(d.extreme); };
    const auto first = std::find_if(band.begin(), band.end(), known);
    if (first == band.end()) return {band.front(), band.back()};
    return {*first, *std::find_if(band.rbegin(), band.rend(), known)};
}

std::string findings_text(const DesignReport& design) {
    int changes = 0, reviews = 0;
    for (const NumberedFinding& n : numbered(design)) {
        changes += n.finding.severity == core::Severity::kRequired ? 1 : 0;
        reviews += n.finding.severity == core::Severity::kReview ? 1 : 0;
    }
    return fmt::format("{} / {}", changes, reviews);
}

}  // namespace

std::string head_section(const DesignReport& design) {
    const core::Provenance& made_by = design.provenance;
    std::string out = "<header><p class=\"eyebrow\">fusee design report</p><h1>" + escape(made_by.name) + "</h1>" +
                      verdict_text(verdict(design)) + "<p class=\"stamp\">" + escape(made_by.line()) + "</p><div class=\"tiles\">";
    if (!design.law.samples.empty())
        out += html_tile(number(design.law.samples.front().tau, 3) + " to " + number(design.law.samples.back().tau, 3) + " Nm",
                         design.law.covers_stiction() ? "loads, all that stiction allows" : "loads, stiction not covered");
    if (!design.dead_band.empty()) {
        const auto [first, last] = exact_ends(design.dead_band);
        out += html_tile(
            fmt::format("{} \u2192 {} deg", number(core::deg_from_rad(first.extreme), 3), number(core::deg_from_rad(last.extreme), 3)),
            fmt::format("exact dead-band, {} to {} Nm", number(first.tau, 3), number(last.tau, 3)));
    }
    if (const double worst = worst_arm_error(design); !std::isnan(worst))
        out += html_tile(number(100.0 * worst, 2) + " %", "worst arm error, read from files");
    return out + html_tile(findings_text(design), "changes required / to review") + "</div></header>\n";
}

std::string report_html(const DesignReport& design) {
    const std::vector<NumberedFinding> findings = numbered(design);
    std::string body = head_section(design);
    for (const PartReport& part : design.parts) body += part_section(part, markers_of(findings, cam::to_string(part.part->cam.kind)));
    body += findings_section(findings) + law_section(design) + dead_band_section(design) + read_back_section(design) +
            as_exported_section(design.as_exported) + files_section(design);
    return html_page(design.provenance.name, body);
}

}  // namespace fusee::report
