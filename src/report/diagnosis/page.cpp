#include "diagnosis/page.h"

#include <fmt/format.h>

#include <cmath>

#include "diagnosis/words.h"
#include "fusee/core/provenance.h"
#include "fusee/report/diagnosis.h"
#include "page/bundle.h"
#include "page/html.h"

namespace fusee::report {

namespace {

using diagnosis::Diagnosis;
using diagnosis::Gap;

std::string diagnosis_verdict(const Diagnosis& diagnosis) {
    switch (diagnosis.verdict) {
        case diagnosis::VerdictKind::kIdentified:
            return verdict_tag(core::Severity::kPass, "Cause identified");
        case diagnosis::VerdictKind::kNone:
            return verdict_tag(core::Severity::kPass, "No gap beyond tolerance and noise");
        case diagnosis::VerdictKind::kAmbiguous:
            return verdict_tag(core::Severity::kWarning, "Cause ambiguous");
        case diagnosis::VerdictKind::kInconclusive:
            return verdict_tag(core::Severity::kWarning, diagnosis.doubts.empty() ? "Too few data for a verdict" : "No certain answer");
        case diagnosis::VerdictKind::kUnknown:
            return verdict_tag(core::Severity::kError, "Cause unknown");
    }
    return "";
}

/// The verdict, its probability and what speaks against it.
std::string head_sentence(const Diagnosis& diagnosis) {
    const double probability = verdict_probability(diagnosis);
    std::string out = verdict_sentence(diagnosis);
    if (std::isfinite(probability)) out += fmt::format(" Probability: {}.", chance(probability));
    for (const std::string& doubt : diagnosis.doubts) out += " Doubt: " + doubt + ".";
    return out;
}

Head diagnosis_head(const Diagnosis& diagnosis) {
    const Gap& gap = diagnosis.gap;
    const bool interval = std::isfinite(gap.heldout_after_95.low) && std::isfinite(gap.heldout_after_95.high);
    return {"fusee diagnosis",
            diagnosis.case_name,
            diagnosis_verdict(diagnosis),
            head_sentence(diagnosis),
            fmt::format("fusee {}, case {}, files {}", core::version(), diagnosis.case_name, diagnosis.case_sha256.substr(0, 12)),
            {{change(gap.before, gap.after) + " sigma", "gap before \u2192 after"},
             {number(gap.noise_floor, 3) + " sigma", "noise floor"},
             {change(gap.heldout_before, gap.heldout_after) + " sigma",
              "on held-out rows" + (interval ? ", after: " + span(gap.heldout_after_95) : std::string())},
             {chance(verdict_probability(diagnosis)),
              diagnosis.effects.size() > 1 ? "probability of the less certain effect" : "probability"}}};
}

std::vector<Cell> gap_row(const Cell& name, const std::string& rows, const Gap& gap, double forecast) {
    return {name,
            num(rows),
            num(gap.before, 3),
            num(gap.after, 3),
            num(gap.noise_floor, 3),
            num(gap.heldout_before, 3),
            num(forecast, 3),
            num(gap.heldout_after, 3),
            num(span(gap.heldout_after_95)),
            num(percent(gap.heldout_after / gap.heldout_before))};
}

std::string how_far_section(const Diagnosis& diagnosis) {
    if (diagnosis.experiments.empty()) return "";
    Rows rows;
    for (const diagnosis::ExperimentGap& e : diagnosis.experiments)
        rows.push_back(gap_row(num(experiment_name(e.experiment)), std::to_string(e.rows), e.gap, e.forecast));
    rows.push_back(gap_row({"<b>all</b>", "num"}, "", diagnosis.gap, diagnosis::kNoFigure));
    return section(
        "How far the gap shrinks",
        paragraph("All in sigma. No fit uses the held-out rows; the forecast is their gap as the fit predicts it.") +
            html_table("Gap of each experiment before and after",
                       {"experiment", "rows", "before", "after", "floor", "held out, before", "forecast", "measured", "95 %", "remaining"},
                       rows));
}

std::string build_section(const Diagnosis& diagnosis) {
    Rows rows;
    for (const auto& [name, raw] : diagnosis.build) {
        const diagnosis::Parameter p = for_reading(raw);
        rows.push_back({num(name), num(p.value, 3), num(span(p.ci95)), plain(p.unit)});
    }
    if (rows.empty()) return "";
    return folded_section("How this rig was built", counted(rows.size(), "figure"),
                          paragraph("Deviations from nominal within the build tolerances, fitted together with the effects.") +
                              dense_table("Build figures as fitted", {"figure", "value", "95 %", "unit"}, rows));
}

std::string set_points(const diagnosis::NextExperiment& next) {
    std::string out;
    for (const double value : next.set_points) out += (out.empty() ? "" : ", ") + number(value, 3);
    return out.empty() || next.variable.empty() ? out : column_name(next.variable) + ": " + out;
}

std::string next_section(const Diagnosis& diagnosis) {
    Rows rows;
    bool listed = diagnosis.next_experiment.empty();
    for (const diagnosis::NextExperiment& next : diagnosis.next) {
        listed = listed || next.text == diagnosis.next_experiment;
        rows.push_back({plain(next.text), num(experiment_name(next.experiment)), plain(set_points(next)), num(next.information, 2),
                        num(next.cost, 2)});
    }
    std::string out = listed ? "" : paragraph(diagnosis.next_experiment);
    if (!rows.empty())
        out += card_table(diagnosis.verdict == diagnosis::VerdictKind::kInconclusive ? "Measurements that show what these rows do not"
                                                                                     : "Measurements that distinguish the causes",
                          {"measurement", "experiment", "set points", "bits expected", "minutes"}, rows);
    return section("Next experiment", out);
}

}  // namespace

std::string diagnosis_html(const Diagnosis& diagnosis, const std::string& extra_section_html, const DesignReport* joint) {
    const std::string marked = joint != nullptr ? marked_joint_section(diagnosis, *joint) : "";
    return html_page(diagnosis.case_name, diagnosis_head(diagnosis),
                     form_section(diagnosis) + trace_section(diagnosis) + where_section(diagnosis) + place_section(diagnosis) + marked +
                         which_section(diagnosis) + transfer_section(diagnosis) + how_far_section(diagnosis) + next_section(diagnosis) +
                         extra_section_html + section("Remarks", bullet_list(diagnosis.remarks)) + power_section(diagnosis) +
                         isolability_section(diagnosis) + build_section(diagnosis),
                     marked.empty() || !joint->assembly ? "" : joint_bundle());
}

}  // namespace fusee::report
