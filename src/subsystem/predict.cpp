#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fit.h"
#include "fusee/core/error.h"

namespace fusee::subsystem {

namespace {

/// A nominal parameter, or the choice of the open input.
std::size_t build_parameter(const Law& law, const std::string& name) {
    for (std::size_t k = 0; k < law.nominal; ++k)
        if (law.parameters[k].name == name) return k;
    if (law.open_input && law.parameters[law.open_input->parameter].name == name) return law.open_input->parameter;
    throw core::InvalidInput("diagnosis", "\"" + name + "\"", "a parameter of this subsystem");
}

const LawEffect& effect_of(const Law& law, const effects::Cause& cause) {
    std::string known;
    for (const LawEffect& effect : law.effects) {
        if (effect.cause == cause) return effect;
        known += (known.empty() ? "" : ", ") + effect.cause.id + (effect.cause.side == "none" ? "" : " " + effect.cause.side);
    }
    throw core::InvalidInput("effects", cause.id + " " + cause.side, known);
}

/// @throws core::InvalidInput for a value beyond what a fit may give the parameter
void put_value(const Law& law, std::size_t parameter, const std::string& what, double value, Values& values) {
    constexpr double kRounding = 1e-9;
    const Parameter& k = law.parameters[parameter];
    const double slack = kRounding * (k.high - k.low);
    if (!(value >= k.low - slack && value <= k.high + slack))
        throw core::InvalidInput(what, fmt::format("{:g}", value),
                                 fmt::format("{:g} to {:g}{}{}", k.low, k.high, k.unit.empty() ? "" : " ", k.unit));
    values[parameter] = value;
}

void put_effect(const Law& law, const diagnosis::FoundEffect& found, Values& values) {
    const LawEffect& effect = effect_of(law, found.cause);
    const std::string what = "effects: " + found.cause.id;
    const Parameter& size = law.parameters[effect.parameters.front()];
    if (values[effect.parameters.front()] != size.null_value) throw core::InvalidInput(what, "stated again", "each effect once on a side");
    if (!found.parameter.unit.empty() && !size.unit.empty() && found.parameter.unit != size.unit)
        throw core::InvalidInput(what + ": unit", found.parameter.unit, size.unit);
    put_value(law, effect.parameters.front(), what, found.parameter.value, values);
    for (const auto& [name, value] : found.extra) {
        const auto known = std::find_if(effect.parameters.begin() + 1, effect.parameters.end(),
                                        [&, &wanted = name](std::size_t k) { return law.parameters[k].name == wanted; });
        if (known == effect.parameters.end()) throw core::InvalidInput(what + ": extra", name, "a further parameter of this effect");
        put_value(law, *known, what + ": " + name, value, values);
    }
}

void require_finite(const Record& record, const std::vector<double>& predicted) {
    const auto none = std::find_if(predicted.begin(), predicted.end(), [](double value) { return !std::isfinite(value); });
    if (none != predicted.end())
        throw core::InvalidInput(record.file, fmt::format("no prediction of row {}", none - predicted.begin() + 1),
                                 "inputs and effects that this subsystem can follow");
}

/// The nominal parameters on the case's own rows, the effects held.
void fit_nominal(const Case& subsystem_case, Values& values) {
    const auto law = law_of(subsystem_case);
    const std::vector<std::size_t> all = all_blocks(*law);
    Values start = values;
    const Values own = start_values(*law);
    std::copy_n(own.begin(), law->nominal, start.begin());
    Fit best = fit(*law, all, free_parameters(*law, {}), start);
    for (const auto& [choice, name] : law->open_input ? law->open_input->choices : std::vector<std::pair<double, const char*>>{}) {
        start[law->open_input->parameter] = choice;
        Fit other = fit(*law, all, free_parameters(*law, {}), start);
        if (other.cost < best.cost) best = std::move(other);
    }
    values = best.values;
}

/// A case's law, or that of its inputs, with the case's own scale: starts and bounds do not matter for a prediction.
Values values_of(const Case& subsystem_case, const diagnosis::Diagnosis& found) {
    const auto law = law_of(subsystem_case);
    Values values = start_values(*law);
    for (const diagnosis::FoundEffect& effect : found.effects) put_effect(*law, effect, values);
    for (const auto& [name, parameter] : found.build)
        put_value(*law, build_parameter(*law, name), "build: " + name, parameter.value, values);
    if (found.build.empty()) fit_nominal(subsystem_case, values);
    return values;
}

}  // namespace

Case predict(const Case& subsystem_case, const diagnosis::Diagnosis& found, const Case& inputs) {
    const Values values = values_of(subsystem_case, found);
    const auto law = law_of(subsystem_case, &inputs);
    if (law->parameters.size() != values.size())
        throw core::InvalidInput("inputs", "motors that the case does not have", "the sides of the case");
    Case out = inputs;
    for (std::size_t r = 0; r < out.records.size(); ++r) {
        std::vector<double>& predicted = out.records[r].columns[law->measured_name];
        law->predict(r, values, predicted);
        require_finite(out.records[r], predicted);
    }
    return out;
}

}  // namespace fusee::subsystem
