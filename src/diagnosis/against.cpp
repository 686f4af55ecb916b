#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "answer.h"
#include "fusee/diagnosis/gap_map.h"
#include "fusee/inference/interval.h"
#include "fusee/inference/screen.h"

namespace fusee::diagnosis {

namespace {

double half_of(const Parameter& parameter) { return 0.5 * parameter.ci95.width(); }

/// @param at_end the size there stopped at an end of its range: of a limit, at the end where it limits nothing
Survival survival_of(const Parameter& here, const Parameter& there, bool is_limit, bool at_end) {
    const bool nothing = is_limit ? at_end : there.ci95.holds(0.0);
    if (std::abs(here.value - there.value) > std::hypot(half_of(here), half_of(there)))
        return nothing ? Survival::kGone : Survival::kDiffers;
    return nothing ? Survival::kOpen : Survival::kAgrees;
}

/// The same diagnosis with its forms as effects: what is carried over.
Diagnosis with_terms(Diagnosis found) {
    for (const UnknownTerm& term : found.unknown_terms) found.effects.push_back(term.found);
    return found;
}

/// The causes of a setting that the experiments of the problem see, and x at its sizes on a rig as stated.
struct Start {
    inference::Causes causes;
    Eigen::VectorXd x;
};
Start start_of(const inference::Problem& problem, const inference::Setting& setting) {
    Start start;
    std::vector<double> sizes;
    const auto is_seen = [&](const inference::Cause& cause, bool generic) {
        const std::vector<inference::Cause> seen = inference::possible_causes(problem, generic);
        return std::find(seen.begin(), seen.end(), cause) != seen.end();
    };
    for (const inference::Setting::Applied& applied : setting.effects) {
        const inference::Effect& effect = problem.effect(applied.cause.id);
        if (!is_seen(applied.cause, effect.generic)) continue;
        start.causes.push_back(applied.cause);
        for (std::size_t k = 0; k < applied.values.size(); ++k) sizes.push_back(applied.values[k] / effect.parameters[k].scale);
    }
    start.x = problem.start(start.causes);
    start.x.tail(static_cast<Eigen::Index>(sizes.size())) =
        Eigen::Map<const Eigen::VectorXd>(sizes.data(), static_cast<Eigen::Index>(sizes.size()));
    return start;
}

/// The gap at a setting; kNoFigure where the model refuses it.
double gap_at(const inference::Problem& problem, const inference::Setting& setting, const Eigen::VectorXd& sigma) {
    try {
        const Eigen::VectorXd residual = problem.residual(problem.model().predict(setting, inference::Extent::kAll));
        return root_mean_square(problem, residual.cwiseQuotient(sigma));
    } catch (const inference::Refusal&) {
        return kNoFigure;
    }
}

/// Fits the causes of the first case there and compares their sizes.
void carry(const inference::Problem& problem, const Diagnosis& found, const Start& start, const Stages& stages, unsigned jobs,
           Against& out) {
    const inference::Fit refit = fit(problem, start.causes, start.x, {.jobs = jobs});
    const inference::Split left_out = experiments_left_out(problem, stages.null(), refit, jobs);
    const std::vector<Parameter> sizes = sizes_of(problem, refit, left_out);
    const inference::Causes ends = inference::at_bounds(problem, refit);
    const Eigen::VectorXd sigma = tolerance_sigma(problem, stages.null().jacobian);
    out.refitted = root_mean_square(problem, refit.residual.cwiseQuotient(sigma));
    for (const FoundEffect& own : found.effects) {
        Against::Carried carried{own.cause, own.parameter, {kNoFigure, {kNoFigure, kNoFigure}, own.parameter.unit}, Survival::kOpen};
        const auto place = std::find(start.causes.begin(), start.causes.end(), own.cause);
        if (place != start.causes.end()) {
            carried.there = sizes[static_cast<std::size_t>(place - start.causes.begin())];
            const bool at_end = std::find(ends.begin(), ends.end(), own.cause) != ends.end();
            carried.survival = survival_of(carried.here, carried.there, problem.effect(own.cause.id).is_limit(), at_end);
        }
        out.causes.push_back(std::move(carried));
    }
}

}  // namespace

const char* to_string(Survival survival) {
    static constexpr std::array<const char*, 4> kNames{"agrees", "differs", "gone", "open"};
    return kNames.at(static_cast<std::size_t>(survival));
}

CarriedGap carried_gap(const inference::Model& other, const Diagnosis& found) {
    const inference::Setting setting = setting_of(other, with_terms(found), found.case_name);
    const inference::Problem problem(other);
    const Eigen::VectorXd stated = problem.start({});
    const Eigen::VectorXd sigma = tolerance_sigma(problem, problem.slopes({}, stated, 0, stated.size()));
    return {gap_at(problem, problem.setting({}, stated), sigma), gap_at(problem, setting, sigma)};
}

Against against(const inference::Model& other, const Subject& subject, const Diagnosis& found, const DiagnoseOptions& options) {
    const Diagnosis all = with_terms(found);
    const inference::Setting setting = setting_of(other, all, subject.name + ": causes of " + found.case_name);
    const inference::Problem problem(other);
    const Stages stages = stages_of(problem, options);
    const Diagnosis own = answer_of(subject, problem, stages);
    Against out{subject.name, subject.sha256, own.verdict, own.effects, {}, own.gap.before};
    out.own = own.gap.after;
    out.carried = gap_at(problem, setting, tolerance_sigma(problem, stages.null().jacobian));
    carry(problem, all, start_of(problem, setting), stages, options.jobs, out);
    return out;
}

}  // namespace fusee::diagnosis
