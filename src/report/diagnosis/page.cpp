#include "diagnosis/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/words.h"
#include "fusee/core/provenance.h"
#include "fusee/report/diagnosis.h"
#include "page/html.h"

namespace fusee::report {

namespace {

using gap::Diagnosis;
using gap::Gap;

std::string verdict_tag(gap::Verdict verdict) {
    switch (verdict) {
        case gap::Verdict::kIdentified:
            return "<span class=\"verdict pass-tag\">\u2713 Cause identified</span>";
        case gap::Verdict::kNone:
            return "<span class=\"verdict pass-tag\">\u2713 No gap beyond tolerance and noise</span>";
        case gap::Verdict::kAmbiguous:
            return "<span class=\"verdict review-tag\">! Cause ambiguous</span>";
        case gap::Verdict::kUnknown:
            return "<span class=\"verdict required-tag\">\u2715 Cause unknown</span>";
    }
    return "";
}

std::string head(const Diagnosis& diagnosis) {
    const Gap& gap = diagnosis.gap;
    const double probability = verdict_probability(diagnosis);
    std::string out =
        "<header><p class=\"eyebrow\">fusee diagnosis</p><h1>" + escape(diagnosis.case_name) + "</h1>" + verdict_tag(diagnosis.verdict) +
        "<p>" + escape(verdict_sentence(diagnosis)) + "</p><p class=\"stamp\">" +
        escape(fmt::format("fusee {}, case {}, files {}", core::version(), diagnosis.case_name, diagnosis.case_sha256.substr(0, 12))) +
        "</p><div class=\"tiles\">";
    out += html_tile(change(gap.before, gap.after) + " sigma", "gap before \u2192 after");
    out += html_tile(known(gap.noise_floor) + " sigma", "noise floor");
    const bool interval = std::isfinite(gap.heldout_after_95.low) && std::isfinite(gap.heldout_after_95.high);
    out += html_tile(change(gap.heldout_before, gap.heldout_after) + " sigma",
                     "on rows kept back" + (interval ? ", after: " + span(gap.heldout_after_95) : std::string()));
    out += html_tile(chance(probability), diagnosis.effects.size() > 1 ? "probability of the less certain effect" : "probability");
    return out + "</div></header>\n";
}

std::vector<Cell> gap_row(const std::string& name, const std::string& rows, const Gap& gap, double forecast) {
    return {{name, "num"},
            {rows, "num"},
            {known(gap.before), "num"},
            {known(gap.after), "num"},
            {known(gap.noise_floor), "num"},
            {known(gap.heldout_before), "num"},
            {known(forecast), "num"},
            {known(gap.heldout_after), "num"},
            {span(gap.heldout_after_95), "num"},
            {percent(gap.heldout_after / gap.heldout_before), "num"}};
}

std::string build_section(const Diagnosis& diagnosis) {
    std::vector<std::vector<Cell>> rows;
    for (const auto& [name, raw] : diagnosis.build) {
        const gap::Parameter p = for_reading(raw);
        rows.push_back({{escape(name), "num"}, {known(p.value), "num"}, {span(p.ci95), "num"}, {escape(p.unit), ""}});
    }
    if (rows.empty()) return "";
    return section("How this rig was built",
                   "<p>Deviations from the nominal figures that build tolerances allow, as fitted together with the effects.</p>"
                   "<div class=\"dense\">" +
                       html_table({"figure", "value", "95 %", "unit"}, rows) + "</div>");
}

std::string set_points(const gap::NextExperiment& next) {
    std::string out;
    for (const double value : next.set_points) out += (out.empty() ? "" : ", ") + known(value);
    return out.empty() || next.variable.empty() ? out : column_name(next.variable) + ": " + out;
}

std::string next_section(const Diagnosis& diagnosis) {
    std::vector<std::vector<Cell>> rows;
    bool told = diagnosis.next_experiment.empty();
    for (const gap::NextExperiment& next : diagnosis.next) {
        told = told || next.text == diagnosis.next_experiment;
        rows.push_back({{escape(next.text), ""},
                        {escape(experiment_name(next.experiment)), "num"},
                        {escape(set_points(next)), ""},
                        {known(next.information, 2), "num"},
                        {known(next.cost, 2), "num"}});
    }
    std::string out = told ? "" : "<p>" + escape(diagnosis.next_experiment) + "</p>";
    if (!rows.empty()) out += html_table({"what to do", "experiment", "set points", "bits expected", "minutes"}, rows);
    return section("Next experiment", out);
}

std::string remark_section(const Diagnosis& diagnosis) {
    if (diagnosis.remarks.empty()) return "";
    std::string out = "<ul>";
    for (const std::string& remark : diagnosis.remarks) out += "<li>" + escape(remark) + "</li>";
    return section("Remarks", out + "</ul>");
}

}  // namespace

std::string section(const std::string& title, const std::string& content) {
    return content.empty() ? "" : "<section><h2>" + escape(title) + "</h2>" + content + "</section>\n";
}

Cell share_cell(double share, const std::string& text) {
    constexpr double kWidth = 90, kHeight = 12;
    if (!std::isfinite(share)) return {text, "num"};
    return {fmt::format("<span style=\"display:flex;align-items:center;gap:10px\"><svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
                        "{1}\"><rect width=\"{0}\" height=\"{1}\" style=\"fill:var(--body)\"/>"
                        "<rect width=\"{2}\" height=\"{1}\" style=\"fill:var(--se)\"/></svg>{3}</span>",
                        kWidth, kHeight, coordinate(kWidth * std::clamp(share, 0.0, 1.0)), escape(text)),
            "num"};
}

std::string how_far_section(const Diagnosis& diagnosis) {
    if (diagnosis.experiments.empty()) return "";
    std::vector<std::vector<Cell>> rows;
    for (const gap::ExperimentGap& e : diagnosis.experiments)
        rows.push_back(gap_row(escape(experiment_name(e.experiment)), std::to_string(e.rows), e.gap, e.forecast));
    rows.push_back(gap_row("<b>all</b>", "", diagnosis.gap, gap::kNoFigure));
    return section("How far the gap shrinks",
                   "<p>All in sigma. Kept back: rows that no fit has seen. The forecast is what the fit expects of them.</p>" +
                       html_table({"experiment", "rows", "before", "after", "floor", "kept back, before", "forecast", "measured", "95 %",
                                   "what is left"},
                                  rows));
}

std::string diagnosis_html(const Diagnosis& diagnosis, const std::string& extra_section_html) {
    return html_page(diagnosis.case_name, head(diagnosis) + where_section(diagnosis) + which_section(diagnosis) +
                                              isolability_section(diagnosis) + how_far_section(diagnosis) + trace_section(diagnosis) +
                                              build_section(diagnosis) + next_section(diagnosis) + remark_section(diagnosis) +
                                              extra_section_html);
}

}  // namespace fusee::report
