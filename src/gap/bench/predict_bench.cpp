#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "fit.h"
#include "fusee/core/error.h"

namespace fusee::gap {

namespace {

using bench::Law;
using bench::Values;

std::size_t knob_named(const Law& law, const std::string& name, std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k)
        if (law.knobs[k].name == name) return k;
    throw core::InvalidInput("diagnosis", "\"" + name + "\"", "a parameter of this bench");
}

const bench::LawEffect& effect_of(const Law& law, const Cause& cause) {
    std::string known;
    for (const bench::LawEffect& effect : law.effects) {
        if (effect.cause == cause) return effect;
        known += (known.empty() ? "" : ", ") + effect.cause.id + (effect.cause.side == "none" ? "" : " " + effect.cause.side);
    }
    throw core::InvalidInput("effects", cause.id + " " + cause.side, known);
}

void put_effect(const Law& law, const FoundEffect& found, Values& values) {
    const bench::LawEffect& effect = effect_of(law, found.cause);
    values[effect.knobs.front()] = found.parameter.value;
    for (const std::size_t k : effect.knobs)
        for (const auto& [name, value] : found.extra)
            if (k != effect.knobs.front() && name == law.knobs[k].name) values[k] = value;
}

/// The nominal parameters on the case's own rows, the effects held.
void fit_nominal(const BenchCase& bench, Values& values) {
    const auto law = bench::law_of(bench);
    std::vector<std::size_t> all(law->blocks.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    Values start = values;
    const Values own = bench::start_values(*law);
    std::copy_n(own.begin(), law->nominal, start.begin());
    values = bench::fit(*law, all, bench::free_knobs(*law, {}), start).values;
}

/// A case's law, or that of its inputs, with the case's own scale: starts and bounds do not matter for a prediction.
Values values_of(const BenchCase& bench, const Diagnosis& found) {
    const auto law = bench::law_of(bench);
    Values values = bench::start_values(*law);
    for (const FoundEffect& effect : found.effects) put_effect(*law, effect, values);
    for (const auto& [name, parameter] : found.build) values[knob_named(*law, name, 0, law->nominal)] = parameter.value;
    if (found.build.empty()) fit_nominal(bench, values);
    return values;
}

const char* measured_column(BenchKind kind) {
    switch (kind) {
        case BenchKind::kFrictionElement:
            return "F_N";
        case BenchKind::kServoPendulum:
            return "q_rad";
        case BenchKind::kMotorBreakaway:
            return "load_torque_Nm";
    }
    return "";
}

}  // namespace

BenchCase predict_bench(const BenchCase& bench, const Diagnosis& found, const BenchCase& inputs) {
    const Values values = values_of(bench, found);
    const auto law = bench::law_of(inputs, true);
    if (law->knobs.size() != values.size()) throw core::InvalidInput("inputs", "other motors than the case's", "the sides of the case");
    BenchCase out = inputs;
    for (std::size_t r = 0; r < out.records.size(); ++r) law->predict(r, values, out.records[r].columns[measured_column(bench.kind)]);
    return out;
}

}  // namespace fusee::gap
