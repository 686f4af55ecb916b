#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/page.h"
#include "diagnosis/words.h"
#include "page/html.h"

namespace fusee::report {

namespace {

constexpr std::size_t kMostHypotheses = 30;

std::string faint(const std::string& text) { return text.empty() ? "" : "<br><span class=\"faint\">" + escape(text) + "</span>"; }

std::string extra_text(const gap::FoundEffect& effect) {
    std::string out;
    for (const auto& [name, value] : effect.extra) out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", name, known(value, 4));
    return faint(out);
}

std::string effect_table(const gap::Diagnosis& diagnosis) {
    if (diagnosis.effects.empty()) return "";
    std::vector<std::vector<Cell>> rows;
    for (const gap::FoundEffect& effect : diagnosis.effects) {
        const gap::Parameter p = for_reading(effect.parameter);
        rows.push_back({{"<b>" + escape(effect.cause.id) + "</b>" + extra_text(effect), "num"},
                        {escape(effect.cause.side), ""},
                        {"<b>" + known(p.value) + "</b>", "num"},
                        {span(p.ci95), "num"},
                        {escape(p.unit), ""},
                        {chance(effect.probability), "num"},
                        {escape(meaning(effect.cause.id)) + faint(law(effect.cause.id)), ""}});
    }
    return html_table({"effect", "side", "size", "95 %", "unit", "probability", "what it means"}, rows);
}

std::string alternative_table(const std::vector<gap::Alternative>& alternatives) {
    if (alternatives.empty()) return "";
    std::vector<std::vector<Cell>> rows;
    rows.reserve(alternatives.size());
    for (const gap::Alternative& alternative : alternatives)
        rows.push_back(
            {{escape(causes_name(alternative.effects)), ""}, share_cell(alternative.probability, chance(alternative.probability))});
    return "<h3 class=\"held\">What else it could be</h3>" + html_table({"effects", "probability"}, rows);
}

std::string sizes(const gap::Hypothesis& hypothesis) {
    std::string out;
    for (const gap::Parameter& raw : hypothesis.parameters) {
        const gap::Parameter p = for_reading(raw);
        out += fmt::format("{}{}", out.empty() ? "" : "; ", amount(p));
    }
    return out;
}

std::string ranking_table(const gap::Diagnosis& diagnosis) {
    if (diagnosis.ranking.empty()) return "";
    const std::vector<gap::Cause> found = found_causes(diagnosis);
    const bool tells = diagnosis.verdict == gap::Verdict::kIdentified || diagnosis.verdict == gap::Verdict::kNone;
    std::vector<std::vector<Cell>> rows;
    for (std::size_t i = 0; i < std::min(kMostHypotheses, diagnosis.ranking.size()); ++i) {
        const gap::Hypothesis& h = diagnosis.ranking[i];
        const bool chosen = tells && std::is_permutation(h.effects.begin(), h.effects.end(), found.begin(), found.end());
        rows.push_back({{escape(causes_name(h.effects, " + ")) + (chosen ? " <span class=\"tag pass-tag\">found</span>" : ""), ""},
                        {escape(sizes(h)), "num"},
                        {known(h.log_evidence), "num"},
                        share_cell(h.probability, chance(h.probability)),
                        {known(h.chi2, 4), "num"},
                        {known(h.left_out), "num"}});
    }
    std::string out =
        "<h3 class=\"held\">Ranking</h3><p>Log evidence is relative to the best. The left-out gap is measured on experiments "
        "that the fit did not see, in sigma.</p><div class=\"dense\">" +
        html_table({"effects", "size", "log evidence [nat]", "probability", "chi\u00b2", "left-out gap"}, rows) + "</div>";
    if (diagnosis.ranking.size() > kMostHypotheses)
        out += fmt::format("<p class=\"faint\">{} more are in diagnosis.json.</p>", diagnosis.ranking.size() - kMostHypotheses);
    return out;
}

}  // namespace

std::string which_section(const gap::Diagnosis& diagnosis) {
    return section("Which effect causes it",
                   effect_table(diagnosis) + alternative_table(diagnosis.alternatives) + ranking_table(diagnosis));
}

}  // namespace fusee::report
