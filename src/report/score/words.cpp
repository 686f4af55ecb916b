#include "score/words.h"

#include <fmt/format.h>

#include <cmath>

#include "diagnosis/words.h"
#include "page/html.h"

namespace fusee::report {

namespace {

void append_text(std::string& text, const std::string& more, const char* between) {
    if (!text.empty()) text += between;
    text += more;
}

}  // namespace

std::string per_cent(double share) { return std::isnan(share) ? number(share) : fmt::format("{:.1f} %", 100.0 * share); }

std::string per_cent(const core::Range& range) {
    if (std::isnan(range.low) || std::isnan(range.high)) return number(range.low - range.high);
    return fmt::format("{:.1f} to {:.1f} %", 100.0 * range.low, 100.0 * range.high);
}

std::string interval_text(const blind::Share& share) { return share.of == 0 ? "" : per_cent(share.wilson95()); }

std::string hits_text(const blind::Share& share) { return fmt::format("{} of {}", share.hits, share.of); }

std::string wanted_text(const core::Range& wanted) {
    const bool low = wanted.low > 0.0, high = wanted.high < 1.0;
    if (!low && !high) return "";
    if (low && high) return fmt::format("{:.0f} to {:.0f} %", 100.0 * wanted.low, 100.0 * wanted.high);
    if (wanted.low == 1.0) return "100 %";
    return low ? fmt::format("at least {:.0f} %", 100.0 * wanted.low) : fmt::format("at most {:.0f} %", 100.0 * wanted.high);
}

std::string truth_text(const blind::Label& label) {
    if (label.effects.empty()) return "none";
    std::string text;
    for (const blind::LabelEffect& e : label.effects)
        append_text(text, fmt::format("{} {}", cause_name({e.id, e.side}), number(e.size, 3)), ", ");
    return text;
}

std::string answer_text(const blind::Answer& answer) {
    if (!answer.failure.empty()) return "failed";
    std::string effects;
    for (const diagnosis::FoundEffect& e : answer.effects)
        append_text(effects, fmt::format("{} {} (95 %: {})", cause_name(e.cause), number(e.parameter.value, 3), span(e.parameter.ci95)),
                    ", ");
    return to_string(answer.verdict) + std::string(effects.empty() ? "" : ": ") + effects;
}

std::string alternatives_text(const blind::Answer& answer) {
    std::string text;
    for (const diagnosis::Alternative& other : answer.alternatives) {
        std::string causes;
        for (const effects::Cause& cause : other.effects) append_text(causes, cause_name(cause), " + ");
        append_text(text, (causes.empty() ? "none" : causes) + " " + chance(other.probability), "; ");
    }
    return text;
}

}  // namespace fusee::report
