#include "unknown_terms.h"

#include <algorithm>
#include <utility>

#include "fusee/inference/interval.h"

namespace fusee::diagnosis {

Parameter parameter_of(double value, double half, const inference::EffectParameter& law) {
    return {value * law.scale,
            {std::max(law.allowed.low, (value - half) * law.scale), std::min(law.allowed.high, (value + half) * law.scale)},
            law.unit};
}

std::vector<UnknownTerm> unknown_terms(const inference::Problem& problem, const inference::FoundTerms& found) {
    std::vector<UnknownTerm> all;
    for (std::size_t c = 0; c < found.fit.causes.size(); ++c) {
        const inference::Cause& cause = found.fit.causes[c];
        const inference::Effect& law = problem.effect(cause.id);
        const int first = problem.effect_size_index(found.fit.causes, c);
        std::vector<double> values;
        for (std::size_t p = 0; p < law.parameters.size(); ++p)
            values.push_back(found.fit.x[first + static_cast<int>(p)] * law.parameters[p].scale);
        const double half = inference::half_interval(found.fit, found.left_out, first);
        UnknownTerm& own = all.emplace_back();
        own.found = {cause, found.probability[c], parameter_of(found.fit.x[first], half, law.parameters.front()), {}};
        for (std::size_t p = 1; p < values.size(); ++p) own.found.extra.emplace_back(law.parameters[p].name, values[p]);
        inference::Form form = problem.model().form_of(cause, values);
        own.port = std::move(form.port);
        own.depends_on = std::move(form.depends_on);
        own.law = law.law;
        own.sentence = std::move(form.sentence);
        own.log_odds = found.log_odds[c];
        own.x_name = std::move(form.x_name);
        own.y_name = std::move(form.y_name);
        own.x = std::move(form.x);
        own.y = std::move(form.y);
    }
    return all;
}

}  // namespace fusee::diagnosis
