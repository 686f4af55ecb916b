#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fusee/core/provenance.h"
#include "fusee/math/statistics.h"
#include "fusee/report/score.h"
#include "page/html.h"
#include "page/svg_plot.h"
#include "score/words.h"

namespace fusee::report {

namespace {

using blind::Score;

Head score_head(const Score& score) {
    Head head{"fusee blind benchmark",
              std::to_string(score.cases) + " sealed cases",
              "",
              "",
              fmt::format("fusee {}, seal sha256:{}", core::version(), score.seal),
              {}};
    for (const char* key : {"effect_named", "effect_and_side", "none_on_null", "both_of_two", "intervals_hold", "held_out_halved",
                            "unknown_called_unknown", "known_called_unknown"}) {
        const blind::Figure& figure = score.figure(key);
        head.tiles.emplace_back(per_cent(figure.share.value()), figure.name);
    }
    return head;
}

Cell wanted_cell(const blind::Figure& figure) {
    const std::string wanted = wanted_text(figure.wanted);
    if (wanted.empty() || figure.share.of == 0) return num(wanted);
    const bool met = figure.wanted.holds(figure.share.value());
    return {tag(met ? core::Severity::kPass : core::Severity::kWarning, wanted), "num"};
}

/// Bold, or "" for an empty text.
Cell strong(const std::string& text) { return {text.empty() ? "" : "<b>" + escape(text) + "</b>", "num"}; }

std::string figure_section(const Score& score, const std::optional<Score>& model) {
    std::vector<std::string> columns{"", "cases", "share", "95 %", "wanted", "labels shuffled", "95 % of shuffles"};
    if (model) columns.push_back("model = plant");
    Rows rows;
    for (const blind::Figure& figure : score.figures) {
        rows.push_back({plain(figure.name), num(hits_text(figure.share)), strong(per_cent(figure.share.value())),
                        num(interval_text(figure.share)), wanted_cell(figure), num(per_cent(figure.shuffled)),
                        num(per_cent(figure.shuffled95))});
        if (model) rows.back().push_back(num(per_cent(model->figure(figure.key).share.value())));
    }
    std::string words = "Intervals are Wilson's. Control: the same answers with shuffled labels score at chance level.";
    if (model)
        words += fmt::format(" Control: the {} cases of the model itself show what the method misses without a model error.", model->cases);
    return section("Figures", paragraph(words) + html_table("Figures of the benchmark", columns, rows));
}

std::string confusion_section(const Score& score) {
    std::set<std::string> answers;
    for (const auto& [truth, said] : score.confusion)
        for (const auto& [answer, count] : said) answers.insert(answer);
    std::vector<std::string> columns{"built in \\ answered"};
    columns.insert(columns.end(), answers.begin(), answers.end());
    Rows rows;
    for (const auto& [truth, said] : score.confusion) {
        std::vector<Cell>& row = rows.emplace_back(std::vector<Cell>{num(truth)});
        for (const std::string& answer : answers) {
            const auto count = said.find(answer);
            const bool right = answer == truth || (answer == "unknown" && truth.starts_with("outside."));
            const std::string figure = count == said.end() ? "" : std::to_string(count->second);
            row.push_back(right ? strong(figure) : num(figure));
        }
    }
    return section("Confusion",
                   paragraph("Cases by the effect built in and the effect answered; correct answers are bold. For two effects it "
                             "shows only how many were answered: the figures above show which.") +
                       dense_table("Cases by effect built in and answered", columns, rows));
}

std::string calibration_section(const Score& score) {
    Rows rows;
    std::vector<double> stated, right, low, high;
    for (const blind::CalibrationBin& bin : score.calibration) {
        rows.push_back({num(fmt::format("{} to {}", bin.stated.low, bin.stated.high)), num(hits_text(bin.right)),
                        num(per_cent(bin.mean_stated)), num(per_cent(bin.right.value())), num(interval_text(bin.right))});
        if (bin.right.of == 0) continue;
        stated.push_back(bin.mean_stated);
        right.push_back(bin.right.value());
        low.push_back(bin.right.wilson95().low);
        high.push_back(bin.right.wilson95().high);
    }
    Plot plot("Stated probability and correct share", "stated", "correct");
    plot.curve("ideal", {0.0, 1.0}, {0.0, 1.0}, "sum", true)
        .points("effects", stated, right, "se")
        .band("95 %", stated, low, high, "se")
        .from_zero();
    return section("Calibration", paragraph("How often the effects that answers name, with their side, were built in.") +
                                      html_table("Stated probability and correct share",
                                                 {"stated", "correct", "mean stated", "correct share", "95 %"}, rows) +
                                      (stated.empty() ? "" : "<div class=\"held\">" + plot.svg() + "</div>"));
}

std::string coverage_section(const Score& score) {
    Rows rows;
    for (const auto& [id, share] : score.coverage)
        rows.push_back({num(id), num(hits_text(share)), num(per_cent(share.value())), num(interval_text(share))});
    return rows.empty() ? ""
                        : section("Intervals", paragraph("95 % intervals of correctly named effects that contain the true size.") +
                                                   html_table("Intervals that contain the true size, by effect",
                                                              {"effect", "contained", "share", "95 %"}, rows));
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
    plot.curve("ideal", {0.0, most}, {0.0, most}, "sum", true).points("cases", claimed, measured, "t").from_zero();
    return section("Claimed and measured reduction of the gap",
                   html_facts({{"cases with a named effect", std::to_string(score.shrink.size())},
                               {"median claimed", number(math::upper_median(claimed), 3)},
                               {"median measured", number(math::upper_median(measured), 3)}}) +
                       "<div class=\"held\">" + plot.svg() + "</div>");
}

std::string time_section(const Score& score) {
    if (std::isnan(score.median_seconds)) return "";
    return section("Time", paragraph(fmt::format("One case on one thread: median {} s, worst {} s.", number(score.median_seconds, 3),
                                                 number(score.worst_seconds, 3))));
}

std::string miss_section(const Score& score) {
    Rows rows;
    for (const blind::Miss& miss : score.misses)
        rows.push_back({num(miss.truth.case_name), plain(miss.what), plain(truth_text(miss.truth)), plain(answer_text(miss.answer)),
                        faint(alternatives_text(miss.answer)), num(change(miss.answer.held_out_before, miss.answer.held_out_after))});
    return section("Misses",
                   rows.empty()
                       ? paragraph("None.")
                       : dense_table("Misses", {"case", "what", "built in", "answer", "alternatives", "held-out gap [sigma]"}, rows));
}

}  // namespace

std::string score_html(const blind::Score& score, const std::optional<blind::Score>& model) {
    return html_page("Blind benchmark", score_head(score),
                     figure_section(score, model) + confusion_section(score) + calibration_section(score) + coverage_section(score) +
                         shrink_section(score) + time_section(score) + miss_section(score));
}

}  // namespace fusee::report
