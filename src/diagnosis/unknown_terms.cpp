#include "unknown_terms.h"

#include <algorithm>
#include <cmath>

#include "fusee/effects/term.h"
#include "fusee/inference/interval.h"

namespace fusee::diagnosis {

namespace {

constexpr std::size_t kPoints = 201;  ///< of a curve

/// The range of what a term depends on, on this rig.
core::Range curve_range_of(const inference::Problem& problem, const effects::Term& term, const std::vector<double>& values) {
    const gap_case::Rows& rows = problem.gap_case().rows;
    if (term.over == "capstan_rad") return {0.0, problem.cams().end()};
    if (term.over == "end_share") return {0.0, 1.0};
    if (term.over == "time_s" || term.over == "session_s") return {0.0, 4.0 * (values.size() > 1 ? values[1] : values[0])};
    if (term.over == "torque_Nm") {
        const gap_case::NominalRig::SpringRow& end = problem.gap_case().rig.springs.back();
        return {0.0, end.se_torque + end.pe_torque};
    }
    double most = 0.1;  // joint_rad: as far as it was seen
    for (const gap_case::DeadBandRow& row : rows.dead_band)
        if (!rows.dead_band_width_only) most = std::max({most, std::abs(row.q_low), std::abs(row.q_high)});
    for (const gap_case::StiffnessRow& row : rows.joint_stiffness) most = std::max(most, std::abs(row.q));
    for (const gap_case::LogRow& row : rows.log) most = std::max(most, std::abs(row.q));
    return {-most, most};
}

}  // namespace

Parameter parameter_of(double value, double half, const effects::EffectParameter& law) {
    return {value * law.scale,
            {std::max(law.allowed.low, (value - half) * law.scale), std::min(law.allowed.high, (value + half) * law.scale)},
            law.unit};
}

std::vector<UnknownTerm> unknown_terms(const inference::Problem& problem, const inference::FoundTerms& found) {
    std::vector<UnknownTerm> all;
    for (std::size_t c = 0; c < found.fit.causes.size(); ++c) {
        const effects::Cause& cause = found.fit.causes[c];
        const effects::Term& term = *effects::term_or_none(cause.id);
        const effects::Effect& law = problem.effect(cause.id);
        const int first = problem.size_at(found.fit.causes, c);
        std::vector<double> values;
        for (std::size_t p = 0; p < law.parameters.size(); ++p)
            values.push_back(found.fit.x[first + static_cast<int>(p)] * law.parameters[p].scale);
        const double half = inference::half_interval(found.fit, found.left_out, first);
        UnknownTerm& own = all.emplace_back();
        own.found = {cause, found.probability[c], parameter_of(found.fit.x[first], half, law.parameters.front()), {}};
        for (std::size_t p = 1; p < values.size(); ++p) own.found.extra.emplace_back(law.parameters[p].name, values[p]);
        own.port = term.port;
        own.depends_on = term.depends_on;
        own.law = law.law;
        own.sentence = effects::sentence_of(term, cause.side, values);
        own.log_odds = found.log_odds[c];
        own.x_name = term.over;
        own.y_name = term.gives;
        const core::Range range = curve_range_of(problem, term, values);
        for (std::size_t i = 0; i < kPoints; ++i) {
            own.x.push_back(range.low + range.width() * static_cast<double>(i) / (kPoints - 1));
            own.y.push_back(term.curve(values, own.x.back()));
        }
    }
    return all;
}

}  // namespace fusee::diagnosis
