#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "data/figures.h"
#include "diagnosis/words.h"
#include "fusee/report/diagnosis.h"

namespace fusee::report {

namespace {

constexpr std::size_t kMostEffects = 4, kMostPlaces = 3, kMostDoubts = 2;

/// "is stiffer (+) or softer (-) than" is "is softer than" of a size below 0.
std::string by_sign(std::string meaning, double size) {
    constexpr std::string_view kOr = " (+) or ", kLess = " (-)";
    const std::size_t more = meaning.find(kOr), less = more == std::string::npos ? more : meaning.find(kLess, more);
    if (less == std::string::npos) return meaning;
    if (!(size < 0.0)) return meaning.erase(more, less + kLess.size() - more);
    const std::size_t word = meaning.rfind(' ', more - 1) + 1;
    meaning.erase(less, kLess.size());
    return meaning.erase(word, more + kOr.size() - word);
}

/// With what the library says of it.
std::string effect_line(const diagnosis::FoundEffect& effect) {
    const diagnosis::Parameter p = in_line(effect.parameter);
    const std::string known = by_sign(meaning(effect.cause.id), effect.parameter.value);
    return fmt::format("  {}: {} (95 %: {} {}), probability {}{}{}", cause_name(effect.cause), amount(p), span(p.ci95), p.unit,
                       chance(effect.probability), known.empty() ? "" : ". ", known);
}

/// Adds what the model itself says of an effect.
void add_words(std::vector<std::string>& lines, const diagnosis::Diagnosis& diagnosis, const std::string& id) {
    for (const diagnosis::Meaning& own : diagnosis.meanings) {
        if (own.id != id) continue;
        if (!own.meaning.empty()) lines.push_back("  " + own.id + ": " + own.meaning);
        if (!own.remedy.empty()) lines.push_back("  remedy: " + own.remedy);
    }
}

/// "in rad 0.031 -> 0.004 (held out 0.0045), in Nm ...": root mean squares over the rows of the experiments of each unit.
std::string unit_gaps(const diagnosis::Diagnosis& diagnosis) {
    std::vector<std::string> parts;
    for (const char* unit : {"rad", "Nm"}) {
        double rows = 0.0, before = 0.0, after = 0.0, held_out = 0.0;
        for (const diagnosis::ExperimentGap& e : diagnosis.experiments) {
            if (e.unit != unit) continue;
            const auto n = static_cast<double>(e.rows);
            rows += n, before += n * e.before_in_unit * e.before_in_unit, after += n * e.after_in_unit * e.after_in_unit;
            held_out += n * e.heldout_in_unit * e.heldout_in_unit;
        }
        if (rows > 0.0)
            parts.push_back(fmt::format("in {} {} (held out {})", unit, change(std::sqrt(before / rows), std::sqrt(after / rows)),
                                        number(std::sqrt(held_out / rows), 3)));
    }
    return fmt::format("{}", fmt::join(parts, ", "));
}

/// Adds how many of `all` are not shown.
void add_rest(std::vector<std::string>& lines, std::size_t shown, std::size_t all, const char* what) {
    if (all > shown) lines.push_back(fmt::format("  ... {} more {} on the page", all - shown, what));
}

}  // namespace

std::string diagnosis_text(const diagnosis::Diagnosis& diagnosis) {
    std::vector<std::string> lines{diagnosis.case_name + ": " + verdict_sentence(diagnosis)};
    for (std::size_t i = 0; i < std::min(kMostDoubts, diagnosis.doubts.size()); ++i) lines.push_back("  doubt: " + diagnosis.doubts[i]);
    add_rest(lines, kMostDoubts, diagnosis.doubts.size(), "doubts");
    const std::size_t effects = std::min(kMostEffects, diagnosis.effects.size());
    for (std::size_t i = 0; i < effects; ++i) lines.push_back(effect_line(diagnosis.effects[i]));
    add_rest(lines, effects, diagnosis.effects.size(), "effects");
    for (std::size_t i = 0; i < effects; ++i) add_words(lines, diagnosis, diagnosis.effects[i].cause.id);
    for (std::size_t i = 0; i < std::min(kMostPlaces, diagnosis.where.size()); ++i)
        lines.push_back(fmt::format("  {} {} of the gap: {}", i == 0 ? "where:" : "      ", percent(diagnosis.where[i].share),
                                    place(diagnosis.where[i])));
    const diagnosis::Gap& gap = diagnosis.gap;
    lines.push_back(fmt::format("  gap: {} sigma, noise floor {}", change(gap.before, gap.after), number(gap.noise_floor, 3)));
    if (std::isfinite(gap.heldout_before))
        lines.push_back(fmt::format("  on held-out rows: {} sigma (95 %: {})", change(gap.heldout_before, gap.heldout_after),
                                    span(gap.heldout_after_95)));
    if (const std::string gaps = unit_gaps(diagnosis); !gaps.empty()) lines.push_back("  " + gaps);
    if (diagnosis.absorption) lines.push_back("  " + absorption_sentence(diagnosis));
    for (const std::string& line : against_lines(diagnosis)) lines.push_back("  " + line);
    if (!diagnosis.next_experiment.empty()) lines.push_back("  next: " + diagnosis.next_experiment);
    const std::size_t left = std::max<std::size_t>(static_cast<std::size_t>(kMostDiagnosisLines), lines.size() + 1) - lines.size();
    const bool fits = diagnosis.remarks.size() <= left;
    const std::size_t remarks = fits ? diagnosis.remarks.size() : left - 1;
    for (std::size_t i = 0; i < remarks; ++i) lines.push_back("  - " + diagnosis.remarks[i]);
    add_rest(lines, remarks, diagnosis.remarks.size(), "remarks");
    return fmt::format("{}\n", fmt::join(lines, "\n"));
}

}  // namespace fusee::report
