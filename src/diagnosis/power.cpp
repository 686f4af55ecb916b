#include "power.h"

#include <algorithm>
#include <cmath>

#include "fusee/inference/constants.h"
#include "fusee/inference/screen.h"
#include "fusee/inference/search.h"
#include "verdict.h"

namespace fusee::diagnosis {

double named_length(double per_scale) {
    const double known = std::pow(inference::kEffectPrior * per_scale, 2);  // information on the size over that of its prior
    const double needed = inference::kEffectOdds + std::log(inference::kSure / (1.0 - inference::kSure)) + 0.5 * std::log1p(known);
    return inference::kMargin * (std::sqrt(2.0 * needed * (1.0 + 1.0 / known)) + inference::kInMostCases);
}

std::vector<Power> powers_of(const inference::Problem& problem, const Isolability& isolability) {
    std::vector<Power> all;
    for (const inference::Cause& cause : inference::causes_of(problem.model())) {
        const inference::Effect& effect = problem.effect(cause.id);
        if (effect.figure) continue;  // a deviation within its tolerance needs not be seen
        const inference::EffectParameter& size = effect.parameters.front();
        Power& own = all.emplace_back(Power{cause, kNoFigure, size.scale, size.unit, false});
        const auto found = std::find(isolability.causes.begin(), isolability.causes.end(), cause);
        if (found == isolability.causes.end()) continue;
        own.least = isolability.named[static_cast<std::size_t>(found - isolability.causes.begin())];
        own.shown =
            effect.is_limit() ? own.least * inference::kUsualWithin >= size.scale : own.least <= inference::kUsualWithin * size.scale;
    }
    return all;
}

std::vector<inference::Cause> not_shown(const std::vector<Power>& powers) {
    std::vector<inference::Cause> causes;
    for (const Power& own : powers)
        if (!own.shown) causes.push_back(own.cause);
    return causes;
}

}  // namespace fusee::diagnosis
