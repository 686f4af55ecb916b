#include "fusee/effects/term.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/core/lists.h"
#include "fusee/core/units.h"
#include "terms.h"

namespace fusee::effects {

namespace {

/// Two digits, without an exponent up to a million.
std::string two_digits(double value) {
    if (std::abs(value) < 100.0 || std::abs(value) >= 1e6) return fmt::format("{:.2g}", value);
    const double step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
    return fmt::format("{:.0f}", step * std::round(value / step));
}

}  // namespace

const std::vector<Term>& term_library() {
    static const std::vector<Term> library = core::joined(gear_terms(), spring_terms(), joint_terms());
    return library;
}

std::vector<Effect> terms_on(const gap_case::Reference& reference) {
    std::vector<Effect> all;
    for (const Term& term : term_library()) {
        all.push_back(term.effect);
        for (EffectParameter& parameter : all.back().parameters) parameter = on_rig(parameter, reference);
    }
    return all;
}

const Term* term_or_none(std::string_view id) {
    return core::find_by(
        term_library(), [](const Term& term) -> std::string_view { return term.effect.id; }, id);
}

const Effect& find_effect_or_term(const std::string& id) {
    const Term* const term = term_or_none(id);
    return term == nullptr ? find_effect(id) : term->effect;
}

std::string sentence_of(const Term& term, const std::string& side, const std::vector<double>& values) {
    const double second = values.size() > 1 ? values[1] : 0.0;
    const std::string owner = side == "both" ? "each side's" : "the " + side + "'s";
    std::string capital = owner;
    capital.front() = owner.front() == 't' ? 'T' : 'E';
    return fmt::format(fmt::runtime(term.sentence), fmt::arg("side", owner), fmt::arg("Side", capital),
                       fmt::arg("size", two_digits(std::abs(values[0]))), fmt::arg("share", two_digits(100.0 * values[0])),
                       fmt::arg("second", two_digits(second)), fmt::arg("turns", fmt::format("{:.3g}", 2.0 * core::kPi * second)));
}

}  // namespace fusee::effects
