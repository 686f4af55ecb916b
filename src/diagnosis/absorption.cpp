#include "absorption.h"

#include <algorithm>
#include <cmath>

#include "fusee/diagnosis/gap_map.h"
#include "fusee/inference/constants.h"
#include "fusee/inference/splits.h"

namespace fusee::diagnosis {

namespace {

/// Deviation of a build parameter in a fit, with the size of its cause where its figure is named.
double deviation(const inference::Problem& problem, const inference::Fit& fit, std::size_t k) {
    const inference::BuildParameter& build = problem.build()[k];
    double sum = fit.x[static_cast<Eigen::Index>(k)] * build.sigma;
    for (std::size_t c = 0; c < fit.causes.size(); ++c) {
        const inference::Cause& cause = fit.causes[c];
        const inference::Effect& effect = problem.effect(cause.id);
        const bool same = effect.figure && cause.id == build.cause.id && (cause.side == build.cause.side || cause.side == "both");
        if (same) sum += fit.x[problem.effect_size_index(fit.causes, c)] * effect.parameters.front().scale / build.cause_size;
    }
    return sum;
}

/// Without a tolerance: how far the cause would move it back, in what is plausible.
double moved_by(const Absorption::Moved& own, double sigma) {
    return std::isfinite(own.tolerances) ? std::abs(own.tolerances) : std::abs(own.value - own.with_cause) / sigma;
}

std::vector<Absorption::Moved> moved_in(const inference::Problem& problem, const inference::Fit& plain, const inference::Fit& shown) {
    std::vector<std::pair<double, Absorption::Moved>> all;
    for (std::size_t k = 0; k < problem.build().size(); ++k) {
        const inference::BuildParameter& build = problem.build()[k];
        const double zero = build.stated ? 0.0 : build.nominal, by = deviation(problem, plain, k);
        const Absorption::Moved own{build.name, zero + by, build.stated ? by / build.sigma : kNoFigure, zero + deviation(problem, shown, k),
                                    build.unit};
        all.emplace_back(moved_by(own, build.sigma), own);
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Absorption::Moved> moved;
    for (auto& [by, own] : all) moved.push_back(std::move(own));
    return moved;
}

}  // namespace

std::optional<Absorption> absorption_of(const inference::Problem& problem, const Stages& stages, unsigned jobs) {
    if (stages.shown().causes.empty() || problem.build().empty()) return std::nullopt;
    const inference::Problem wide(problem.model(), inference::kPlainWidth);
    const inference::Fit plain = fit(wide, {}, stages.null().x, {.jobs = jobs});
    const Eigen::VectorXd sigma = tolerance_sigma(problem, stages.null().jacobian);
    const inference::Split held = held_out(wide, plain, plain, jobs);
    return Absorption{moved_in(problem, plain, stages.shown()), root_mean_square(problem, plain.residual.cwiseQuotient(sigma)),
                      root_mean_square(problem, held.residual.cwiseQuotient(sigma))};
}

}  // namespace fusee::diagnosis
