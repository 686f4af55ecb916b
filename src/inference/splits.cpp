#include "fusee/inference/splits.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "fusee/core/parallel.h"
#include "fusee/inference/screen.h"

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
        base.x = descend(problem_, base.spread, problem_.held(null_.jacobian), {{}, problem_.start({}), 0.0}, {}, &kept).x;
        for (const Cause& cause : fit_.causes) {
            Guess with = guess_upon(problem_, base, cause, &kept);
            base.causes = std::move(with.causes);
            base.x = std::move(with.x);
            base.jacobian = joined(null_.jacobian, problem_.slopes(base.causes, base.x, null_.jacobian.cols(), base.x.size()));
        }
        return settled({base.causes, base.x, 0.0}, kept);
    }
    [[nodiscard]] Refit on(const std::vector<bool>& kept) const {
        Refit refit{from_nominal(kept)};
        if (const Guess other = settled({fit_.causes, fit_.x, 0.0}, kept); other.cost < refit.end.cost) {
            refit.improvement = refit.end.cost - other.cost;
            refit.end = other;
        }
        refit.end.x = problem_.with_positive_ripples(refit.end.causes, refit.end.x);
        return refit;
    }

private:
    [[nodiscard]] Guess settled(Guess start, const std::vector<bool>& kept) const {
        const auto build = static_cast<Eigen::Index>(problem_.build().size());
        return descend(problem_, fit_.spread, problem_.held(fit_.jacobian.leftCols(build)), std::move(start), {}, &kept);
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

}  // namespace fusee::inference
