#include "diagnosis/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "data/figures.h"
#include "fusee/core/lists.h"
#include "fusee/effects/effect.h"

namespace fusee::report {

namespace {

using Words = std::pair<std::string_view, std::string_view>;

/// Effects of subsystem cases; those of a joint state their meaning in their own file.
constexpr std::array kSubsystemMeanings{
    Words{"element.presliding", "The contact yields like a spring before it slides."},
    Words{"element.backlash", "The element moves by this much before it grips in the other direction."},
    Words{"element.asymmetry", "The friction differs between the two directions."},
    Words{"element.viscous", "The friction grows with speed."},
    Words{"element.stribeck", "The friction is greater at rest than in motion."},
    Words{"element.load", "The friction follows the load on the element."},
    Words{"law.scale",
          "The torque is this much greater (+) or smaller (-) than designed at every angle: another "
          "rate of the spring, or another seat of the slider that sets it."},
    Words{"law.series", "Something between cam and dynamometer yields under the torque."},
    Words{"law.preload", "The cam starts this far along its law: wound (+) or slack (-)."},
    Words{"law.hysteresis", "Unloading gives back less torque than loading takes, in proportion to it."},
    Words{"law.coulomb", "A constant friction opposes the motion of the joint."},
    Words{"law.arm", "The cam's arm differs from the designed one by a smooth curve over the angle."},
    Words{"sensor.torque_offset", "The dynamometer shows this torque where there is none."},
    Words{"loop.delay", "The position loop acts this late."},
    Words{"loop.gain", "The position loop is stiffer (+) or softer (-) than its nominal gain."}};

constexpr std::array kUnits{Words{"_Nms", "Nms"}, Words{"_Nm", "Nm"}, Words{"_m_s", "m/s"}, Words{"_rad", "rad"}, Words{"_N", "N"},
                            Words{"_m", "m"},     Words{"_s", "s"},   Words{"_kg", "kg"},   Words{"_A", "A"},     Words{"_V", "V"}};

std::string spaced(std::string_view id) {
    std::string out(id);
    std::replace(out.begin(), out.end(), '_', ' ');
    return out;
}

struct Column {
    std::string name, unit;
};
Column column_of(std::string_view column) {
    for (const auto& [ending, unit] : kUnits)
        if (column.ends_with(ending) && column.size() > ending.size())
            return {experiment_name(std::string(column.substr(0, column.size() - ending.size()))), std::string(unit)};
    return {spaced(column), ""};
}

constexpr double kWorthNaming = 0.05;

/// The effects found and their probable alternatives, each once.
std::vector<std::string> choices(const diagnosis::Diagnosis& diagnosis) {
    std::vector<std::string> names;
    const auto add = [&names](const std::vector<effects::Cause>& causes) {
        const std::string name = causes_name(causes);
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    if (!diagnosis.effects.empty()) add(found_causes(diagnosis));
    for (const diagnosis::Alternative& alternative : diagnosis.alternatives)
        if (alternative.probability >= kWorthNaming || names.size() < 2) add(alternative.effects);
    return names;
}

std::size_t count_not_shown(const std::vector<diagnosis::Power>& power) {
    return static_cast<std::size_t>(std::count_if(power.begin(), power.end(), [](const diagnosis::Power& own) { return !own.shown; }));
}

}  // namespace

std::string chance(double probability) {
    return probability < 1e-3 ? "< 0.001" : probability >= 0.9995 ? "> 0.999" : number(probability, 3);
}

diagnosis::Parameter for_reading(diagnosis::Parameter parameter) {
    if (parameter.unit == "1") parameter.unit.clear();
    if (parameter.unit != "m") return parameter;
    return {core::mm_from_m(parameter.value), {core::mm_from_m(parameter.ci95.low), core::mm_from_m(parameter.ci95.high)}, "mm"};
}

diagnosis::Parameter in_line(const diagnosis::Parameter& parameter) {
    diagnosis::Parameter p = for_reading(parameter);
    if (p.unit.empty()) p = {100.0 * p.value, {100.0 * p.ci95.low, 100.0 * p.ci95.high}, "%"};
    return p;
}

std::string amount(const diagnosis::Parameter& parameter) {
    return parameter.unit.empty() ? number(parameter.value, 3) : number(parameter.value, 3) + " " + parameter.unit;
}

std::string experiment_name(const std::string& id) {
    if (id == "breakaway") return "break-away";
    if (id == "dead_band") return "dead-band";
    if (id == "cocontraction") return "co-contraction";
    if (id.find(".csv") != std::string::npos) return id;  // names a file
    return id == "log" ? "time log" : spaced(id);
}

std::string column_name(std::string_view column) {
    const Column parts = column_of(column);
    return parts.unit.empty() ? parts.name : parts.name + " [" + parts.unit + "]";
}

std::string cause_name(const effects::Cause& cause) {
    return cause.side.empty() || cause.side == "none" ? cause.id : cause.id + " (" + cause.side + ")";
}
std::string causes_name(const std::vector<effects::Cause>& causes, const std::string& between) {
    std::string out;
    for (const effects::Cause& cause : causes) out += (out.empty() ? "" : between) + cause_name(cause);
    return out.empty() ? "no effect" : out;
}
std::string meaning(std::string_view effect_id) {
    if (const Words* words = core::find_by(kSubsystemMeanings, &Words::first, effect_id)) return std::string(words->second);
    const effects::Effect* const effect = effects::effect_or_none(effect_id);
    return effect == nullptr ? "" : effect->meaning;
}

std::vector<std::string_view> subsystem_effects() {
    std::vector<std::string_view> ids;
    for (const Words& words : kSubsystemMeanings) ids.push_back(words.first);
    return ids;
}

std::string law(std::string_view effect_id) {
    const effects::Effect* const effect = effects::effect_or_none(effect_id);
    if (effect == nullptr) return "";
    if (effect->confused_with.empty()) return effect->law;
    return fmt::format("{} Similar signature: {}.", effect->law, fmt::join(effect->confused_with, ", "));
}

std::string place(const diagnosis::GapContribution& where) {
    std::string out = experiment_name(where.experiment);
    if (!where.variable.empty()) {
        const Column over = column_of(where.variable);
        out += ", " + over.name + " " + span(where.region) + (over.unit.empty() ? "" : " " + over.unit);
    }
    return where.component.empty() ? out : out + ", " + where.component;
}

std::vector<effects::Cause> found_causes(const diagnosis::Diagnosis& diagnosis) {
    std::vector<effects::Cause> causes;
    for (const diagnosis::FoundEffect& effect : diagnosis.effects) causes.push_back(effect.cause);
    return causes;
}

std::string form_of(const diagnosis::Diagnosis& diagnosis) {
    return core::listed(diagnosis.unknown_terms, &diagnosis::UnknownTerm::sentence, " ");
}

namespace {

std::string effects_counted(const diagnosis::Diagnosis& diagnosis) {
    return diagnosis.effects.size() == 1 ? "an effect" : fmt::format("{} effects", diagnosis.effects.size());
}

/// What does not explain the gap: the hypotheses that were tried, not every possible one.
std::string tried(const diagnosis::Diagnosis& diagnosis) {
    return diagnosis.ranking.empty() ? "no hypothesis that was fitted"
                                     : fmt::format("none of the {} hypotheses that were fitted", diagnosis.ranking.size());
}

}  // namespace

std::string verdict_sentence(const diagnosis::Diagnosis& diagnosis) {
    switch (diagnosis.verdict) {
        case diagnosis::VerdictKind::kIdentified:
            return fmt::format("The rig has {} that the model lacks: {}.", effects_counted(diagnosis),
                               causes_name(found_causes(diagnosis)));
        case diagnosis::VerdictKind::kNone:
            return "Model and rig agree within build tolerance and noise.";
        case diagnosis::VerdictKind::kInconclusive:
            if (!diagnosis.doubts.empty()) return "Model and rig agree, but a doubt forbids a verdict.";
            return fmt::format("Model and rig agree, but these rows would not show a usual size of {} of {} causes.",
                               count_not_shown(diagnosis.power), diagnosis.power.size());
        case diagnosis::VerdictKind::kAmbiguous:
            if (!diagnosis.doubts.empty() && diagnosis.alternatives.empty())
                return fmt::format("Model and rig diverge; the likely cause is {}, but a doubt forbids a verdict.",
                                   causes_name(found_causes(diagnosis), " with "));
            return fmt::format("Model and rig diverge; these experiments do not distinguish the possible causes: {}.",
                               fmt::format("{}", fmt::join(choices(diagnosis), "; or ")));
        case diagnosis::VerdictKind::kUnknown:
            if (!diagnosis.unknown_terms.empty())
                return "Model and rig diverge; " + tried(diagnosis) + " explains the gap, but its form is known. " + form_of(diagnosis);
            return "Model and rig diverge; " + tried(diagnosis) + " explains the gap" +
                   (diagnosis.where.empty() ? std::string(".") : ", which lies in: " + place(diagnosis.where.front()) + ".");
        case diagnosis::VerdictKind::kPartlyExplained:
            return fmt::format("The rig has {} that the model lacks: {}. That explains a part of the gap: {:.2g} of {:.2g} sigma remain{}.",
                               effects_counted(diagnosis), causes_name(found_causes(diagnosis)), diagnosis.gap.after, diagnosis.gap.before,
                               diagnosis.where.empty() ? "" : ", most in: " + place(diagnosis.where.front()));
    }
    return "";
}

namespace {

constexpr double kAsWell = 1.15;  // ratio of two gaps up to which one is as good as the other
constexpr double kMoved = 3.0;    // tolerances from which the reader is told of a parameter
constexpr double kShifted = 0.1;  // of a figure without a tolerance, from which the reader is told of it
constexpr std::size_t kMostMoved = 3;

/// Where the plain fit hides the cause: "mass_kg (+12 tolerances)"; of a figure without a tolerance both values.
std::string moved_by(const diagnosis::Absorption& absorption) {
    std::vector<std::string> all;
    for (const diagnosis::Absorption::Moved& own : absorption.moved) {
        if (all.size() == kMostMoved) break;
        const auto read = [&](double value) { return amount(for_reading({value, {value, value}, own.unit})); };
        if (std::isfinite(own.tolerances) && std::abs(own.tolerances) >= kMoved)
            all.push_back(fmt::format("{} ({}{} tolerances)", own.name, own.tolerances > 0.0 ? "+" : "", number(own.tolerances, 3)));
        const double most = std::max(std::abs(own.value), std::abs(own.with_cause));
        if (!std::isfinite(own.tolerances) && std::abs(own.value - own.with_cause) > kShifted * most)
            all.push_back(fmt::format("{} ({} for {})", own.name, read(own.value), read(own.with_cause)));
    }
    return fmt::format("{}", fmt::join(all, ", "));
}

/// The causes that are no figures of the model; those a plain fit finds by itself.
std::string hidden_causes(const diagnosis::Diagnosis& diagnosis) {
    std::vector<effects::Cause> causes = found_causes(diagnosis);
    std::erase_if(causes, [&](const effects::Cause& cause) {
        const auto& moved = diagnosis.absorption->moved;
        return std::any_of(moved.begin(), moved.end(), [&](const auto& own) { return own.name == cause.id; });
    });
    if (!causes.empty()) return causes_name(causes);
    return diagnosis.effects.empty() ? "the cause" : "";
}

}  // namespace

std::string absorption_sentence(const diagnosis::Diagnosis& diagnosis) {
    if (!diagnosis.absorption) return "";
    const diagnosis::Absorption& plain = *diagnosis.absorption;
    const diagnosis::Gap& gap = diagnosis.gap;
    const bool as_well = plain.after <= kAsWell * gap.after, transfers = plain.heldout_after <= kAsWell * gap.heldout_after;
    const std::string fits = as_well ? fmt::format("explains the log as well ({} sigma)", number(plain.after, 2))
                                     : fmt::format("leaves {} sigma of the log, not {},", number(plain.after, 2), number(gap.after, 2)),
                      held = fmt::format("{} sigma, not {}", number(plain.heldout_after, 2), number(gap.heldout_after, 2)),
                      costs = transfers ? fmt::format("as good on the rows held out ({} sigma)", number(plain.heldout_after, 2))
                                        : fmt::format("{} times worse on the rows held out ({})",
                                                      number(plain.heldout_after / gap.heldout_after, 2), held);
    const std::string hidden = hidden_causes(diagnosis), moved = moved_by(plain),
                      tells = hidden.empty()  ? ": it finds " + causes_name(found_causes(diagnosis)) + ", too"
                              : moved.empty() ? (as_well ? ": it moves no parameter far" : ": it cannot hide " + hidden)
                                              : fmt::format(": it hides {}{} in {}", as_well ? "" : "a part of ", hidden, moved);
    return fmt::format("A fit of all parameters {} {} is {}{}.", fits, as_well && !transfers ? "but" : "and", costs, tells);
}

std::vector<std::string> against_lines(const diagnosis::Diagnosis& diagnosis) {
    if (!diagnosis.against) return {};
    const diagnosis::Against& other = *diagnosis.against;
    std::vector<std::string> lines;
    for (const diagnosis::Against::Carried& own : other.causes) {
        const diagnosis::Parameter here = in_line(own.here), there = in_line(own.there);
        const std::string size = std::isfinite(there.value)
                                     ? fmt::format("{} here, {} there (95 %: {})", amount(here), amount(there), span(there.ci95))
                                     : amount(here) + " here, not measured there";
        lines.push_back(fmt::format("against {}: {}: {}: {}", other.case_name, cause_name(own.cause), size, to_string(own.survival)));
    }
    std::vector<effects::Cause> causes;
    for (const diagnosis::FoundEffect& effect : other.effects) causes.push_back(effect.cause);
    const std::string carried = other.causes.empty() ? ""
                                                     : fmt::format("{} with these causes as they are, {} with their sizes fitted there, ",
                                                                   number(other.carried, 3), number(other.refitted, 3));
    lines.push_back(fmt::format("gap of {}: {} sigma, {}{} with its own diagnosis ({}: {})", other.case_name, number(other.before, 3),
                                carried, number(other.own, 3), to_string(other.verdict), causes_name(causes)));
    return lines;
}

double verdict_probability(const diagnosis::Diagnosis& diagnosis) {
    double least = diagnosis::kNoFigure;
    if (diagnosis.verdict == diagnosis::VerdictKind::kIdentified || diagnosis.verdict == diagnosis::VerdictKind::kPartlyExplained)
        for (const diagnosis::FoundEffect& effect : diagnosis.effects) least = std::fmin(least, effect.probability);
    if (diagnosis.verdict == diagnosis::VerdictKind::kNone || diagnosis.verdict == diagnosis::VerdictKind::kInconclusive)
        for (const diagnosis::Hypothesis& hypothesis : diagnosis.ranking)
            if (hypothesis.effects.empty()) least = hypothesis.probability;
    return least;
}

}  // namespace fusee::report
