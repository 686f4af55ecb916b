#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fusee/core/error.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/inference/problem.h"

namespace fusee::diagnosis {

namespace {

constexpr double kRoundingOfSize = 1e-9;  // of the range in which a size lies

double allowed_value(const std::string& place, const inference::EffectParameter& law, double value) {
    const double slack = kRoundingOfSize * law.allowed.width();
    if (value >= law.allowed.low - slack && value <= law.allowed.high + slack) return value;
    throw core::InvalidInput(place, fmt::format("{:g}", value),
                             fmt::format("{:g} to {:g} {}", law.allowed.low, law.allowed.high, law.unit));
}

inference::Setting::Applied applied(const inference::Effect& effect, const FoundEffect& found, const std::string& place) {
    inference::Setting::Applied own{found.cause, {allowed_value(place, effect.parameters.front(), found.parameter.value)}};
    for (std::size_t k = 1; k < effect.parameters.size(); ++k) {
        const inference::EffectParameter& law = effect.parameters[k];
        const auto known = std::find_if(found.extra.begin(), found.extra.end(), [&](const auto& extra) { return extra.first == law.name; });
        own.values.push_back(known == found.extra.end() ? law.at_first : allowed_value(place + ": " + law.name, law, known->second));
    }
    return own;
}

}  // namespace

inference::Setting setting_of(const inference::Model& model, const Diagnosis& found, const std::string& file) {
    const inference::Problem problem(model);
    inference::Setting setting{std::vector<double>(model.build().size(), 0.0), {}};
    std::vector<std::string> names;
    for (const inference::BuildParameter& build : model.build()) names.push_back(build.name);
    for (const auto& [name, parameter] : found.build) {
        const auto place = std::find(names.begin(), names.end(), name);
        if (place == names.end()) throw core::InvalidInput(file + ": build", name, fmt::format("{}", fmt::join(names, ", ")));
        setting.build[static_cast<std::size_t>(place - names.begin())] = parameter.value;
    }
    for (const FoundEffect& own : found.effects) {
        const inference::Effect& effect = problem.effect(own.cause.id);
        if (std::find(effect.sides.begin(), effect.sides.end(), own.cause.side) == effect.sides.end())
            throw core::InvalidInput(file + ": " + own.cause.id + ": side", own.cause.side,
                                     fmt::format("{}", fmt::join(effect.sides, ", ")));
        setting.effects.push_back(applied(effect, own, file + ": " + own.cause.id));
    }
    return setting;
}

}  // namespace fusee::diagnosis
