#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/page.h"
#include "diagnosis/words.h"
#include "page/html.h"

namespace fusee::report {

namespace {

constexpr std::size_t kMostHypotheses = 30;

std::string faint_line(const std::string& text) { return text.empty() ? "" : "<br><span class=\"faint\">" + escape(text) + "</span>"; }

std::string extra_text(const diagnosis::FoundEffect& effect) {
    std::string out;
    for (const auto& [name, value] : effect.extra) out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", name, number(value, 4));
    return faint_line(out);
}

std::string effect_table(const diagnosis::Diagnosis& diagnosis) {
    if (diagnosis.effects.empty()) return "";
    Rows rows;
    for (const diagnosis::FoundEffect& effect : diagnosis.effects) {
        const diagnosis::Parameter p = for_reading(effect.parameter);
        rows.push_back({{"<b>" + escape(effect.cause.id) + "</b>" + extra_text(effect), "num"},
                        plain(effect.cause.side),
                        {"<b>" + number(p.value, 3) + "</b>", "num"},
                        num(span(p.ci95)),
                        plain(p.unit),
                        num(chance(effect.probability)),
                        {escape(meaning(effect.cause.id)) + faint_line(law(effect.cause.id)), ""}});
    }
    return html_table("Effects found", {"effect", "side", "size", "95 %", "unit", "probability", "meaning"}, rows);
}

std::string alternative_table(const std::vector<diagnosis::Alternative>& alternatives) {
    if (alternatives.empty()) return "";
    Rows rows;
    for (const diagnosis::Alternative& alternative : alternatives)
        rows.push_back({plain(causes_name(alternative.effects)), share_cell(alternative.probability, chance(alternative.probability))});
    return subheading("Alternatives") + html_table("Alternatives", {"effects", "probability"}, rows);
}

std::string sizes_text(const diagnosis::Hypothesis& hypothesis) {
    std::string out;
    for (const diagnosis::Parameter& raw : hypothesis.parameters) {
        const diagnosis::Parameter p = for_reading(raw);
        out += fmt::format("{}{}", out.empty() ? "" : "; ", amount(p));
    }
    return out;
}

std::string ranking_table(const diagnosis::Diagnosis& diagnosis) {
    if (diagnosis.ranking.empty()) return "";
    const std::vector<effects::Cause> found = found_causes(diagnosis);
    const bool decided = diagnosis.verdict == diagnosis::VerdictKind::kIdentified || diagnosis.verdict == diagnosis::VerdictKind::kNone;
    Rows rows;
    for (std::size_t i = 0; i < std::min(kMostHypotheses, diagnosis.ranking.size()); ++i) {
        const diagnosis::Hypothesis& h = diagnosis.ranking[i];
        const bool chosen = decided && std::is_permutation(h.effects.begin(), h.effects.end(), found.begin(), found.end());
        rows.push_back({{escape(causes_name(h.effects, " + ")) + (chosen ? " <span class=\"tag pass-tag\">found</span>" : ""), ""},
                        num(sizes_text(h)),
                        num(h.log_evidence, 3),
                        share_cell(h.probability, chance(h.probability)),
                        num(h.chi2, 4),
                        num(h.left_out, 3)});
    }
    std::string out = paragraph(
                          "The log evidence is relative to the best. The left-out gap, in sigma, is that of experiments that the fit did "
                          "not use.") +
                      dense_table("Hypotheses by probability",
                                  {"effects", "size", "log evidence [nats]", "probability", "chi\u00b2", "left-out gap"}, rows);
    if (diagnosis.ranking.size() > kMostHypotheses)
        out += faint_paragraph(fmt::format("diagnosis.json holds {} more.", diagnosis.ranking.size() - kMostHypotheses));
    return folded("Ranking of all hypotheses", out);
}

}  // namespace

std::string which_section(const diagnosis::Diagnosis& diagnosis) {
    return section("Which effect causes it",
                   effect_table(diagnosis) + alternative_table(diagnosis.alternatives) + ranking_table(diagnosis));
}

}  // namespace fusee::report
