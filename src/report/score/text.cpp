#include <fmt/format.h>

#include <cmath>

#include "data/figures.h"
#include "fusee/report/score.h"
#include "page/bundle.h"
#include "score/words.h"

namespace fusee::report {

std::string score_text(const blind::Score& score, const std::optional<blind::Score>& model) {
    static constexpr auto kLine = "{:<60} {:>9} {:>8}   {:<16} {:<14} {:>8}{}\n";
    const auto model_column = [&](const std::string& text) { return model ? fmt::format(" {:>8}", text) : ""; };
    std::string out = fmt::format("{} cases, seal sha256:{}\n", score.cases, score.seal);
    out += fmt::format(kLine, "", "cases", "share", "95 %", "wanted", "shuffled", model_column("model"));
    for (const blind::Figure& figure : score.figures)
        out += fmt::format(kLine, figure.name, fmt::format("{}/{}", figure.share.hits, figure.share.of), per_cent(figure.share.value()),
                           interval_text(figure.share), wanted_text(figure.wanted),
                           std::isnan(figure.shuffled) ? "" : per_cent(figure.shuffled),
                           model_column(model ? per_cent(model->figure(figure.key).share.value()) : ""));
    if (!std::isnan(score.median_seconds))
        out += fmt::format("one case on one thread: median {} s, worst {} s\n", number(score.median_seconds, 3),
                           number(score.worst_seconds, 3));
    return out + fmt::format("{} misses; the page and score.json list each\n", score.misses.size());
}

std::string score_html(const blind::Score& score, const std::optional<blind::Score>& model) {
    return page_file({"score", "Blind benchmark", score_text(score, model), {{"result", blind::score_json(score, model)}}});
}

std::string per_cent(double share) { return std::isnan(share) ? number(share) : fmt::format("{:.1f} %", 100.0 * share); }

std::string per_cent(const core::Range& range) {
    if (std::isnan(range.low) || std::isnan(range.high)) return number(range.low - range.high);
    return fmt::format("{:.1f} to {:.1f} %", 100.0 * range.low, 100.0 * range.high);
}

std::string interval_text(const blind::Share& share) { return share.of == 0 ? "" : per_cent(share.wilson95()); }

std::string wanted_text(const core::Range& wanted) {
    const bool low = wanted.low > 0.0, high = wanted.high < 1.0;
    if (!low && !high) return "";
    if (low && high) return fmt::format("{:.0f} to {:.0f} %", 100.0 * wanted.low, 100.0 * wanted.high);
    if (wanted.low == 1.0) return "100 %";
    return low ? fmt::format("at least {:.0f} %", 100.0 * wanted.low) : fmt::format("at most {:.0f} %", 100.0 * wanted.high);
}

}  // namespace fusee::report
