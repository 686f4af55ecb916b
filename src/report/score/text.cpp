#include <fmt/format.h>

#include <cmath>

#include "diagnosis/words.h"
#include "fusee/report/score.h"
#include "score/words.h"

namespace fusee::report {

std::string score_text(const blind::Score& score, const std::optional<blind::Score>& model) {
    std::string out = fmt::format("{} cases, seal sha256:{}\n{:<60} {:>9} {:>8}   {:<16} {:<14} {:>8}", score.cases, score.seal, "",
                                  "cases", "share", "95 %", "wanted", "shuffled");
    out += model ? fmt::format(" {:>8}\n", "model") : "\n";
    for (const blind::Figure& figure : score.figures) {
        out +=
            fmt::format("{:<60} {:>9} {:>8}   {:<16} {:<14} {:>8}", figure.name, fmt::format("{}/{}", figure.share.hits, figure.share.of),
                        per_cent(figure.share.value()), interval_text(figure.share), wanted_text(figure.wanted),
                        std::isnan(figure.shuffled) ? "" : per_cent(figure.shuffled));
        out += model ? fmt::format(" {:>8}\n", per_cent(model->figure(figure.key).share.value())) : "\n";
    }
    if (!std::isnan(score.median_seconds))
        out += fmt::format("a case on one thread: median {} s, worst {} s\n", known(score.median_seconds), known(score.worst_seconds));
    return out + fmt::format("{} of the cases are missed in some way; each is listed on the page and in score.json\n", score.misses.size());
}

}  // namespace fusee::report
