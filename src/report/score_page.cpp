#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis_page.h"
#include "diagnosis_words.h"
#include "fusee/core/provenance.h"
#include "fusee/math/statistics.h"
#include "fusee/report/score.h"
#include "html.h"
#include "score_words.h"
#include "svg_plot.h"

namespace fusee::report {

namespace {

using blind::Score;
using Table = std::vector<std::vector<Cell>>;

std::string paragraph(const std::string& text) { return "<p>" + escape(text) + "</p>"; }

std::string head(const Score& score) {
    std::string out = "<header><p class=\"eyebrow\">fusee blind benchmark</p><h1>" + std::to_string(score.cases) +
                      " sealed cases</h1><p class=\"stamp\">" +
                      escape(fmt::format("fusee {}, seal sha256:{}", core::version(), score.seal)) + "</p><div class=\"tiles\">";
    for (const char* key : {"effect_named", "effect_and_side", "none_on_null", "both_of_two", "intervals_hold", "kept_back_halved",
                            "unknown_called_unknown", "known_called_unknown"}) {
        const blind::Figure& figure = score.figure(key);
        out += html_tile(per_cent(figure.share.value()), figure.name);
    }
    return out + "</div></header>\n";
}

Cell met_cell(const blind::Figure& figure) {
    const std::string wanted = wanted_text(figure.wanted);
    if (wanted.empty() || figure.share.of == 0) return {escape(wanted), "num"};
    const bool met = figure.wanted.holds(figure.share.value());
    return {fmt::format("<span class=\"tag {}\">{}</span>", met ? "pass-tag" : "review-tag", escape(wanted)), "num"};
}

std::string figure_section(const Score& score, const std::optional<Score>& model) {
    std::vector<std::string> columns{"", "cases", "share", "95 %", "wanted", "labels shuffled", "95 % of shuffles"};
    if (model) columns.push_back("model = plant");
    Table rows;
    for (const blind::Figure& figure : score.figures) {
        rows.push_back({{escape(figure.name), ""},
                        {fmt::format("{} of {}", figure.share.hits, figure.share.of), "num"},
                        {"<b>" + per_cent(figure.share.value()) + "</b>", "num"},
                        {interval_text(figure.share), "num"},
                        met_cell(figure),
                        {per_cent(figure.shuffled), "num"},
                        {per_cent(figure.shuffled95), "num"}});
        if (model) rows.back().push_back({per_cent(model->figure(figure.key).share.value()), "num"});
    }
    std::string words = "Intervals are Wilson's. Two controls: the same answers under labels that were dealt anew score at chance";
    words += model ? fmt::format("; the model's own cases ({}) show what the method misses where model and rig agree.", model->cases) : ".";
    return section("Figures", paragraph(words) + html_table(columns, rows));
}

std::string confusion_section(const Score& score) {
    std::set<std::string> answers;
    for (const auto& [truth, said] : score.confusion)
        for (const auto& [answer, count] : said) answers.insert(answer);
    std::vector<std::string> columns{"built in \\ answered"};
    columns.insert(columns.end(), answers.begin(), answers.end());
    Table rows;
    for (const auto& [truth, said] : score.confusion) {
        rows.push_back({{escape(truth), "num"}});
        for (const std::string& answer : answers) {
            const auto count = said.find(answer);
            const bool right = answer == truth || (answer == "unknown" && truth.starts_with("outside."));
            const std::string figure = count == said.end() ? "" : std::to_string(count->second);
            rows.back().push_back({right && !figure.empty() ? "<b>" + figure + "</b>" : figure, "num"});
        }
    }
    return section("Confusion",
                   paragraph("Cases by what was built in and what was answered; what is right stands out. Of two effects it only "
                             "says how many were answered: the figures above say which.") +
                       "<div class=\"dense\">" + html_table(columns, rows) + "</div>");
}

std::string calibration_section(const Score& score) {
    Table rows;
    std::vector<double> stated, right, low, high;
    for (const blind::CalibrationBin& bin : score.calibration) {
        rows.push_back({{fmt::format("{} to {}", bin.stated.low, bin.stated.high), "num"},
                        {fmt::format("{} of {}", bin.right.hits, bin.right.of), "num"},
                        {per_cent(bin.mean_stated), "num"},
                        {per_cent(bin.right.value()), "num"},
                        {interval_text(bin.right), "num"}});
        if (bin.right.of == 0) continue;
        stated.push_back(bin.mean_stated);
        right.push_back(bin.right.value());
        low.push_back(bin.right.wilson95().low);
        high.push_back(bin.right.wilson95().high);
    }
    Plot plot("Probability stated and share right", "stated", "right");
    plot.curve("as stated", {0.0, 1.0}, {0.0, 1.0}, "sum", true)
        .points("effects", stated, right, "se")
        .band("95 %", stated, low, high, "se")
        .from_zero();
    return section("Calibration", paragraph("Of the effects that answers name, with their side: how often they were built in.") +
                                      html_table({"stated", "right", "mean stated", "share right", "95 %"}, rows) +
                                      (stated.empty() ? "" : "<div class=\"held\">" + plot.svg() + "</div>"));
}

std::string coverage_section(const Score& score) {
    Table rows;
    for (const auto& [id, share] : score.coverage)
        rows.push_back({{escape(id), "num"},
                        {fmt::format("{} of {}", share.hits, share.of), "num"},
                        {per_cent(share.value()), "num"},
                        {interval_text(share), "num"}});
    return rows.empty() ? ""
                        : section("Intervals", paragraph("95 % intervals of rightly named effects that hold the true size.") +
                                                   html_table({"effect", "held", "share", "95 %"}, rows));
}

std::string shrink_section(const Score& score) {
    if (score.shrink.empty()) return "";
    std::vector<double> claimed, measured;
    for (const blind::ShrinkRow& row : score.shrink) {
        claimed.push_back(row.claimed);
        measured.push_back(row.measured);
    }
    const double most = std::max(1.0, *std::max_element(claimed.begin(), claimed.end()));
    Plot plot("Gap after over gap before", "claimed by the diagnosis", "measured on heldout/");
    plot.curve("as claimed", {0.0, most}, {0.0, most}, "sum", true).points("cases", claimed, measured, "t").from_zero();
    return section("Shrink claimed and measured", html_facts({{"cases with an effect named", std::to_string(score.shrink.size())},
                                                              {"median claimed", known(math::upper_median(claimed))},
                                                              {"median measured", known(math::upper_median(measured))}}) +
                                                      "<div class=\"held\">" + plot.svg() + "</div>");
}

std::string time_section(const Score& score) {
    if (std::isnan(score.median_seconds)) return "";
    return section("Time", paragraph(fmt::format("A case on one thread: median {} s, worst {} s.", known(score.median_seconds),
                                                 known(score.worst_seconds))));
}

std::string miss_section(const Score& score) {
    Table rows;
    for (const blind::Miss& miss : score.misses)
        rows.push_back({{escape(miss.truth.case_name), "num"},
                        {escape(miss.what), ""},
                        {escape(truth_text(miss.truth)), ""},
                        {escape(answer_text(miss.answer)), ""},
                        {escape(alternatives_text(miss.answer)), "faint"},
                        {change(miss.answer.kept_before, miss.answer.kept_after), "num"}});
    if (rows.empty()) return section("Misses", paragraph("None."));
    return section("Misses", "<div class=\"dense\">" +
                                 html_table({"case", "what", "built in", "answer", "alternatives", "kept-back gap [sigma]"}, rows) +
                                 "</div>");
}

}  // namespace

std::string score_html(const blind::Score& score, const std::optional<blind::Score>& model) {
    return html_page("Blind benchmark", head(score) + figure_section(score, model) + confusion_section(score) + calibration_section(score) +
                                            coverage_section(score) + shrink_section(score) + time_section(score) + miss_section(score));
}

}  // namespace fusee::report
