#include "fusee/inference/splits.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/core/parallel.h"
#include "fusee/inference/constants.h"
#include "fusee/inference/interval.h"
#include "fusee/inference/screen.h"
#include "refine.h"

namespace fusee::inference {

namespace {

struct Refit {
    Guess end;
    double improvement = 0.0;  ///< by the start at the fit of all rows
};

/// Refits of one hypothesis, each on some of the rows.
class Refits {
public:
    Refits(const Problem& problem, const Fit& null, const Fit& fit) : problem_(problem), null_(null), fit_(fit) {}

    /// A guess from the nominal rig: build parameters first, then each cause upon them. Looks at the rows `kept` only.
    [[nodiscard]] Guess from_nominal(const std::vector<bool>& kept) const {
        Fit base = null_;
        HeldSlopes held{null_.jacobian, null_.x};
        base.x = descend(problem_, base.spread, held, {{}, problem_.start({}), 0.0}, {}, &kept).x;
        base.jacobian = held.slopes;
        for (const Cause& cause : fit_.causes) {
            Guess with = guess_upon(problem_, base, cause, &kept);
            base.causes = std::move(with.causes);
            base.x = std::move(with.x);
            problem_.renew(held, base.causes, base.x);
            base.jacobian = joined(held.slopes, problem_.slopes(base.causes, base.x, held.at.size(), base.x.size()));
        }
        return settled({base.causes, base.x, 0.0}, kept);
    }
    /// A simulator's runs are dear: its refits begin at the fit of all rows alone.
    [[nodiscard]] Refit on(const std::vector<bool>& kept) const {
        const Guess other = settled({fit_.causes, fit_.x, 0.0}, kept);
        Refit refit{problem_.has_figures() ? other : from_nominal(kept)};
        if (other.cost < refit.end.cost) {
            refit.improvement = refit.end.cost - other.cost;
            refit.end = other;
        }
        refit.end.x = problem_.with_positive_ripples(refit.end.causes, refit.end.x);
        return refit;
    }

private:
    [[nodiscard]] Guess settled(Guess start, const std::vector<bool>& kept) const {
        const auto build = static_cast<Eigen::Index>(problem_.build().size());
        HeldSlopes held{fit_.jacobian.leftCols(build), fit_.x.head(build)};
        return descend(problem_, fit_.spread, held, std::move(start), {}, &kept);
    }
    const Problem& problem_;
    const Fit &null_, &fit_;
};

/// Adds what the refit without group `g` says about the rows of that group.
void predict_group(const Problem& problem, const Fit& fit, const std::vector<int>& group, int g, const Refit& refit, Split& split) {
    std::vector<bool> kept(group.size());
    for (std::size_t i = 0; i < group.size(); ++i) kept[i] = group[i] != g;
    const Eigen::VectorXd residual = problem.residual(fit.causes, refit.end.x);
    const Eigen::MatrixXd covariance = information(problem, fit, residual.cwiseQuotient(fit.spread), &kept)
                                           .llt()
                                           .solve(Eigen::MatrixXd::Identity(fit.x.size(), fit.x.size()));
    const auto part = static_cast<std::size_t>(g);
    split.x[part] = refit.end.x;
    split.sigma[part] = covariance.diagonal().cwiseSqrt();
    split.improvement[part] = refit.improvement;
    for (Eigen::Index i = 0; i < residual.size(); ++i) {
        if (kept[static_cast<std::size_t>(i)]) continue;
        split.residual[i] = residual[i];
        const Eigen::RowVectorXd slope = fit.jacobian.row(i);
        split.expected[i] = std::sqrt(fit.spread[i] * fit.spread[i] + slope.dot(covariance * slope.transpose()));
    }
}

Split by_groups(const Problem& problem, const Fit& null, const Fit& fit, const std::vector<int>& group, int groups, unsigned jobs) {
    const auto parts = static_cast<std::size_t>(groups);
    Split split{Eigen::VectorXd::Zero(problem.residual_count()), Eigen::VectorXd::Zero(problem.residual_count()),
                std::vector<Eigen::VectorXd>(parts), std::vector<Eigen::VectorXd>(parts), std::vector<double>(parts)};
    const Refits refits(problem, null, fit);
    core::parallel_for(parts, jobs, [&](std::size_t part) {
        const int g = static_cast<int>(part);
        std::vector<bool> kept(group.size());
        for (std::size_t i = 0; i < group.size(); ++i) kept[i] = group[i] != g;
        if (std::find(kept.begin(), kept.end(), false) != kept.end()) predict_group(problem, fit, group, g, refits.on(kept), split);
    });
    return split;
}

/// x[k] of the refits without an experiment whose others would see such a size: the rest go back to the prior and say nothing. Nor do those
/// that the prior draws towards 0 by more than a sigma, as it does sizes far above the usual one.
std::vector<double> sizes_without(const Fit& fit, const Split& left_out, int k) {
    const double size = std::abs(fit.x[k]);
    std::vector<double> sizes;
    for (std::size_t e = 0; e < left_out.x.size(); ++e) {
        if (left_out.x[e].size() == 0) continue;
        const double sigma = left_out.sigma[e][k];
        if (kWitness * sigma < size && size * sigma < kEffectPrior * kEffectPrior) sizes.push_back(left_out.x[e][k]);
    }
    return sizes;
}

}  // namespace

std::vector<int> folds(const Problem& problem) {
    std::vector<int> fold;
    for (const Experiment& experiment : problem.experiments())
        for (const Place& place : experiment.places) fold.push_back(place.block % kFolds);
    return fold;
}

Split held_out(const Problem& problem, const Fit& null, const Fit& fit, unsigned jobs) {
    return by_groups(problem, null, fit, folds(problem), kFolds, jobs);
}

Split experiments_left_out(const Problem& problem, const Fit& null, const Fit& fit, unsigned jobs) {
    std::vector<int> group;
    for (int i = 0; i < problem.residual_count(); ++i) group.push_back(static_cast<int>(problem.experiment_of(i)));
    return by_groups(problem, null, fit, group, static_cast<int>(problem.experiments().size()), jobs);
}

double student95(std::size_t samples) {
    constexpr std::array kStudent95{3.182446, 2.776445, 2.570582};  // of 3, 4 and 5 degrees of freedom
    return kStudent95[std::clamp<std::size_t>(samples, 4, 6) - 4];
}

double half_interval(const Fit& fit, const Split& left_out, int k) {
    const std::vector<double> sizes = sizes_without(fit, left_out, k);
    const double n = static_cast<double>(sizes.size());
    double mean = 0.0, square = 0.0;
    for (const double size : sizes) mean += size / n;
    for (const double size : sizes) square += (size - mean) * (size - mean);
    const double jackknife = n > 1.0 ? square * (n - 1.0) / n : 0.0;
    return std::hypot(kNormal95 * std::sqrt(fit.covariance(k, k)), kNormal95 * kLawAccuracy * fit.x[k],
                      student95(sizes.size()) * std::sqrt(jackknife));
}

Causes contradicted(const Problem& problem, const Fit& fit, const Split& left_out) {
    Causes causes;
    for (std::size_t c = 0; c < fit.causes.size(); ++c) {
        const int k = problem.effect_size_index(fit.causes, c);
        const bool stands_off = std::abs(fit.x[k]) >= kStandOff * half_interval(fit, left_out, k);
        const bool witnessed = sizes_without(fit, left_out, k).size() >= kWitnesses;
        if (!stands_off && witnessed && !problem.effect(fit.causes[c].id).is_limit()) causes.push_back(fit.causes[c]);
    }
    return causes;
}

Causes at_bounds(const Problem& problem, const Fit& fit) {
    Causes causes;
    for (std::size_t c = 0; c < fit.causes.size(); ++c) {
        const int k = problem.effect_size_index(fit.causes, c);
        const core::Range allowed = problem.allowed(fit.causes, k);
        const bool inside = fit.x[k] > allowed.low + kAtEnd * allowed.width() && fit.x[k] < allowed.high - kAtEnd * allowed.width();
        if (!inside) causes.push_back(fit.causes[c]);
    }
    return causes;
}

}  // namespace fusee::inference
