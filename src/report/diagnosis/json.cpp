#include "diagnosis/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "diagnosis/words.h"
#include "fusee/core/provenance.h"
#include "fusee/effects/effect.h"
#include "fusee/effects/term.h"
#include "fusee/report/diagnosis.h"
#include "page/bundle.h"

namespace fusee::report {

namespace {

using diagnosis::Trace;

/// Every `step`th row with a known x, rounded to six digits.
Json thinned_column_json(const Trace& trace, const std::vector<double>& values, std::size_t step) {
    Json all = Json::array();
    for (std::size_t i = 0; i < trace.x.size(); i += step)
        if (std::isfinite(trace.x[i]))
            all.push_back(i < values.size() && std::isfinite(values[i])
                              ? Json(std::strtod(fmt::format("{:.6g}", values[i]).c_str(), nullptr))
                              : Json());
    return all;
}

/// Sum of the squares of (measured - predicted)/sigma over the rows that have all three.
double squared_gap(const Trace& trace, const std::vector<double>& predicted) {
    double sum = 0.0;
    for (std::size_t i = 0; i < std::min({trace.measured.size(), predicted.size(), trace.sigma.size()}); ++i)
        if (const double gap = (trace.measured[i] - predicted[i]) / trace.sigma[i]; std::isfinite(gap)) sum += gap * gap;
    return sum;
}

/// What the effects explain; the whole gap of a trace that has no prediction with them.
double explained_gap(const Trace& trace) {
    const bool known = std::any_of(trace.after.begin(), trace.after.end(), [](double value) { return std::isfinite(value); });
    return squared_gap(trace, trace.before) - (known ? squared_gap(trace, trace.after) : 0.0);
}

/// What the page says of each effect that the diagnosis names, by its id.
Json meanings_json(const diagnosis::Diagnosis& d) {
    std::vector<effects::Cause> causes = found_causes(d);
    for (const diagnosis::Alternative& other : d.alternatives) causes.insert(causes.end(), other.effects.begin(), other.effects.end());
    Json all = Json::object();
    for (const effects::Cause& cause : causes)
        all[cause.id] = {
            {"meaning", meaning(cause.id)}, {"law", law(cause.id)}, {"of_joint", effects::effect_or_none(cause.id) != nullptr}};
    for (const diagnosis::Meaning& own : d.meanings)
        all[own.id] = {{"meaning", own.meaning}, {"law", own.law}, {"remedy", own.remedy}, {"of_joint", false}};
    return all;
}

/// Units of the further parameters of a term's law.
std::vector<std::string> term_units(const diagnosis::UnknownTerm& term) {
    std::vector<std::string> units;
    const std::vector<effects::EffectParameter>& parameters = effects::find_effect_or_term(term.found.cause.id).parameters;
    for (std::size_t i = 1; i < parameters.size(); ++i) units.push_back(parameters[i].unit);
    return units;
}

}  // namespace

std::size_t drawn_points(std::size_t traces) {
    constexpr std::size_t kFewestPoints = 20;
    return std::clamp(kMostPoints / std::max<std::size_t>(1, traces), kFewestPoints, kMostPointsOfATrace);
}

Json traces_json(const std::vector<Trace>& traces) {
    const std::size_t most = drawn_points(traces.size());
    return json_list(traces, [&](const Trace& trace) {
        const std::size_t step = std::max<std::size_t>(1, (trace.x.size() + most - 1) / most);
        const auto of = [&](const std::vector<double>& values) { return thinned_column_json(trace, values, step); };
        return Json{{"experiment", trace.experiment},
                    {"label", trace.label},
                    {"x_name", trace.x_name},
                    {"y_name", trace.y_name},
                    {"rows", trace.x.size()},
                    {"explained", explained_gap(trace)},
                    {"x", of(trace.x)},
                    {"measured", of(trace.measured)},
                    {"before", of(trace.before)},
                    {"after", of(trace.after)},
                    {"sigma", of(trace.sigma)}};
    });
}

std::string full_diagnosis_json(const diagnosis::Diagnosis& d) {
    Json j = Json::parse(diagnosis::diagnosis_json(d));
    j["fusee"] = core::version();
    j["sentence"] = verdict_sentence(d);
    if (d.absorption) j["absorption"]["sentence"] = absorption_sentence(d);
    j["probability"] = verdict_probability(d);
    j["meanings"] = meanings_json(d);
    j["term_units"] = json_list(d.unknown_terms, term_units);
    j["traces"] = traces_json(d.traces);
    return json_text(std::move(j));
}

std::string diagnosis_html(const diagnosis::Diagnosis& d, const std::string& redesign, const std::optional<JointScene>& joint) {
    Page page{"diagnosis",
              d.case_name,
              diagnosis_text(d),
              {{"result", full_diagnosis_json(d)}, {"redesign", redesign.empty() ? "null" : redesign}}};
    if (joint && (!d.effects.empty() || !d.alternatives.empty())) add_joint(page, joint->plan, joint->scene);
    return page_file(page);
}

}  // namespace fusee::report
