#include "answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fusee/diagnosis/gap_map.h"
#include "fusee/inference/constants.h"
#include "fusee/inference/interval.h"
#include "unknown_terms.h"

namespace fusee::diagnosis {

namespace {

/// 95 % interval over the folds of the gap on held-out rows.
core::Range interval_over_folds(const inference::Problem& problem, const Eigen::VectorXd& held) {
    const std::vector<int> fold = folds(problem);
    const std::set<int> parts(fold.begin(), fold.end());  // fewer than kFolds where a case has fewer blocks
    const auto count = static_cast<double>(parts.size());
    if (parts.size() < 2) return {kNoFigure, kNoFigure};
    double mean = 0.0, square = 0.0;
    for (const int f : parts) {
        Eigen::VectorXd own = held;
        for (int i = 0; i < own.size(); ++i)
            if (fold[static_cast<std::size_t>(i)] != f) own[i] = 0.0;
        const double gap = root_mean_square(problem, own) * std::sqrt(count);
        mean += gap / count;
        square += gap * gap / count;
    }
    const double half = inference::student95(parts.size()) * std::sqrt(std::max(0.0, square - mean * mean) / (count - 1.0));
    return {std::max(0.0, mean - half), mean + half};
}

/// Root mean square of an experiment's residuals in the unit of its values.
double in_unit(const inference::Problem& problem, const Eigen::VectorXd& residual, std::size_t e) {
    double sum = 0.0;
    std::size_t next = 0;
    for (int i = 0; i < residual.size(); ++i)
        if (problem.experiment_of(i) == e) sum += std::pow(residual[i] * problem.experiments()[e].sigma[next++], 2);
    return std::sqrt(sum / static_cast<double>(next));
}

/// "8 torques"
std::string blocks_of(const inference::Experiment& experiment) {
    std::set<int> blocks;
    for (const inference::Place& place : experiment.places) blocks.insert(place.block);
    return experiment.blocks.empty() ? "" : fmt::format("{} {}", blocks.size(), experiment.blocks);
}

ExperimentGap experiment_gap(const inference::Problem& problem, const Stages& stages, const inference::Outputs& nominal, std::size_t e) {
    const inference::Experiment& experiment = problem.experiments()[e];
    ExperimentGap own{experiment.name, experiment.rows, {}, kNoFigure, blocks_of(experiment), experiment.unit};
    if (experiment.unit.empty()) return own;
    own.before_in_unit = in_unit(problem, problem.residual(nominal), e);
    own.after_in_unit = in_unit(problem, stages.shown().residual, e);
    own.heldout_in_unit = in_unit(problem, stages.held_out.residual, e);
    return own;
}

/// Reduction of the gap, on the rows of the fit and on held-out rows.
void put_gaps(const inference::Problem& problem, const Stages& stages, const inference::Outputs& nominal, Diagnosis& out) {
    const Eigen::VectorXd sigma = tolerance_sigma(problem, stages.null().jacobian);
    const Eigen::VectorXd before = problem.residual(nominal).cwiseQuotient(sigma);
    const Eigen::VectorXd after = stages.shown().residual.cwiseQuotient(sigma), held = stages.held_out.residual.cwiseQuotient(sigma);
    const Eigen::VectorXd floor = sigma.cwiseInverse(), expected = stages.held_out.expected.cwiseQuotient(sigma);
    const auto gap = [&](const std::size_t* only) {
        Gap g;
        g.before = g.heldout_before = root_mean_square(problem, before, only);
        g.after = root_mean_square(problem, after, only);
        g.noise_floor = root_mean_square(problem, floor, only);
        g.heldout_after = root_mean_square(problem, held, only);
        return g;
    };
    out.gap = gap(nullptr);
    out.gap.heldout_after_95 = interval_over_folds(problem, held);
    for (std::size_t e = 0; e < problem.experiments().size(); ++e) {
        if (problem.experiments()[e].rows == 0) continue;
        ExperimentGap& own = out.experiments.emplace_back(experiment_gap(problem, stages, nominal, e));
        own.gap = gap(&e);
        own.forecast = root_mean_square(problem, expected, &e);
    }
    out.map = gap_map(problem, before, after);
    const bool formless = stages.decision.verdict == VerdictKind::kUnknown && !stages.terms;
    const bool remains = formless || stages.decision.verdict == VerdictKind::kPartlyExplained;
    out.where = gap_contributions(problem, remains ? after : before);
}

void put_build(const inference::Problem& problem, const inference::Fit& shown, Diagnosis& out) {
    for (std::size_t k = 0; k < problem.build().size(); ++k) {
        const inference::BuildParameter& build = problem.build()[k];
        const auto i = static_cast<Eigen::Index>(k);
        const double value = (build.stated ? 0.0 : build.nominal) + shown.x[i] * build.sigma,
                     half = inference::kNormal95 * std::sqrt(shown.covariance(i, i)) * build.sigma;
        out.build.push_back({build.name, {value, {value - half, value + half}, build.unit}});
    }
}

std::vector<Hypothesis> ranking_of(const inference::Problem& problem, const inference::Search& found, const Eigen::VectorXd& sigma) {
    std::vector<Hypothesis> ranking;
    for (std::size_t h = 0; h < found.fits.size(); ++h) {
        const inference::Fit& fit = found.fits[h];
        const inference::Split& left_out = found.left_out[h];
        Hypothesis row{fit.causes, found.log_posterior[h], found.probability[h], fit.cost, kNoFigure, sizes_of(problem, fit, left_out)};
        if (!left_out.x.empty()) row.left_out = root_mean_square(problem, left_out.residual.cwiseQuotient(sigma));
        ranking.push_back(std::move(row));
    }
    return ranking;
}

/// The effects of a hypothesis that is named.
std::vector<FoundEffect> effects_of(const inference::Problem& problem, const inference::Search& found, const inference::Fit& named,
                                    const inference::Split& left_out) {
    const std::vector<Parameter> sizes = sizes_of(problem, named, left_out);
    std::vector<FoundEffect> all;
    for (std::size_t c = 0; c < named.causes.size(); ++c) {
        const inference::Effect& effect = problem.effect(named.causes[c].id);
        const auto k = static_cast<std::size_t>(problem.effect_size_index(named.causes, c));
        FoundEffect own{named.causes[c], 0.0, sizes[c], {}};
        for (std::size_t h = 0; h < found.fits.size(); ++h) {
            const inference::Causes& others = found.fits[h].causes;
            if (std::find(others.begin(), others.end(), own.cause) != others.end()) own.probability += found.probability[h];
        }
        for (std::size_t p = 1; p < effect.parameters.size(); ++p)
            own.extra.emplace_back(effect.parameters[p].name, named.x[static_cast<Eigen::Index>(k + p)] * effect.parameters[p].scale);
        all.push_back(std::move(own));
    }
    return all;
}

/// Every likely hypothesis but the one that is named, and what nothing distinguishes from it; without a name the best one too.
std::vector<Alternative> alternatives_of(const Stages& stages) {
    const inference::Search& found = stages.found;
    const auto is_likely = [&](std::size_t h) {
        const std::vector<std::size_t>& alike = stages.decision.indistinct;
        return h == 0 || found.probability[h] >= inference::kLeastAlternative || std::find(alike.begin(), alike.end(), h) != alike.end();
    };
    const bool named = stages.decision.verdict != VerdictKind::kUnknown;
    std::vector<Alternative> all;
    for (std::size_t h = 0; h < found.fits.size(); ++h)
        if (is_likely(h) && !(named && found.fits[h].causes == stages.shown().causes))
            all.push_back({found.fits[h].causes, found.probability[h]});
    return all;
}

/// "It is 2.3 % above what was stated (95 %: 1.4 to 3.2 %)."
std::string deviation_text(const Parameter& size) {
    const bool share = size.unit == "1", length = size.unit == "m", below = size.value < 0.0;
    const double factor = (share    ? 100.0
                           : length ? 1000.0
                                    : 1.0) *
                          (below ? -1.0 : 1.0),
                 low = factor * size.ci95.low, high = factor * size.ci95.high;
    const std::string unit = share ? " %" : length ? " mm" : " " + size.unit;
    return fmt::format(" It is {:.3g}{} {} what was stated (95 %: {:.3g} to {:.3g}{}).", factor * size.value, unit,
                       below ? "below" : "above", std::min(low, high), std::max(low, high), unit);
}

/// The model's own words for each effect that the answer names. Of a figure they say how far it is from what was stated.
std::vector<Meaning> meanings_of(const inference::Problem& problem, const Diagnosis& out) {
    std::vector<inference::Cause> causes;
    for (const FoundEffect& effect : out.effects) causes.push_back(effect.cause);
    for (const Alternative& other : out.alternatives) causes.insert(causes.end(), other.effects.begin(), other.effects.end());
    std::vector<Meaning> all;
    for (const inference::Cause& cause : causes) {
        const inference::Effect& effect = problem.effect(cause.id);
        const bool told = std::any_of(all.begin(), all.end(), [&](const Meaning& own) { return own.id == cause.id; });
        if (told || (effect.meaning.empty() && effect.remedy.empty())) continue;
        all.push_back({effect.id, effect.meaning, effect.remedy, effect.law});
        const auto named = std::find_if(out.effects.begin(), out.effects.end(), [&](const FoundEffect& own) { return own.cause == cause; });
        if (effect.figure && named != out.effects.end()) all.back().meaning += deviation_text(named->parameter);
    }
    return all;
}

}  // namespace

std::vector<Parameter> sizes_of(const inference::Problem& problem, const inference::Fit& fit, const inference::Split& left_out) {
    std::vector<Parameter> sizes;
    for (std::size_t c = 0; c < fit.causes.size(); ++c) {
        const int k = problem.effect_size_index(fit.causes, c);
        const inference::EffectParameter& size = problem.effect(fit.causes[c].id).parameters.front();
        sizes.push_back(parameter_of(fit.x[k], inference::half_interval(fit, left_out, k), size));
    }
    return sizes;
}

const inference::Fit& Stages::shown() const {
    if (decision.shown == Shown::kTerms) return terms->fit;
    if (decision.shown == Shown::kPart) return part->fit;
    return decision.shown == Shown::kBest ? found.best() : null();
}

Diagnosis answer_of(const Subject& subject, const inference::Problem& problem, const Stages& stages) {
    Diagnosis out;
    out.case_name = subject.name;
    out.case_sha256 = subject.sha256;
    out.verdict = stages.decision.verdict;
    out.remarks = problem.model().remarks();
    out.remarks.insert(out.remarks.end(), stages.decision.remarks.begin(), stages.decision.remarks.end());
    const inference::Outputs nominal = problem.predict({}, problem.as_stated(stages.null().x));
    put_gaps(problem, stages, nominal, out);
    put_build(problem, stages.shown(), out);
    out.traces = traces_of(problem, nominal, problem.predict(stages.shown().causes, stages.shown().x));
    out.ranking = ranking_of(problem, stages.found, tolerance_sigma(problem, stages.null().jacobian));
    if (stages.decision.shown == Shown::kBest)
        out.effects = effects_of(problem, stages.found, stages.shown(), stages.found.left_out.front());
    if (stages.decision.shown == Shown::kPart) out.effects = effects_of(problem, stages.found, stages.shown(), stages.part->left_out);
    out.alternatives = alternatives_of(stages);
    out.meanings = meanings_of(problem, out);
    if (stages.terms) out.unknown_terms = unknown_terms(problem, *stages.terms);
    out.isolability = stages.isolability;
    out.power = stages.decision.power;
    out.absorption = stages.absorption;
    out.next = stages.next;
    if (!out.next.empty()) out.next_experiment = out.next.front().text;
    return out;
}

}  // namespace fusee::diagnosis
