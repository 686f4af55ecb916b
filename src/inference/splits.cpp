#include "fusee/inference/splits.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>

#include "fusee/core/parallel.h"
#include "fusee/gap_case/reference.h"
#include "fusee/inference/screen.h"

namespace fusee::inference {

namespace {

constexpr std::size_t kStretch = 8;  ///< rows of a path that are held out together
constexpr double kLogStretch = 0.5;  ///< of the reference rig [s]

template <typename RowList, typename Figure>
std::vector<double> levels(const RowList& rows, const Figure& figure) {
    std::set<double> all;
    for (const auto& row : rows) all.insert(figure(row));
    return {all.begin(), all.end()};
}

int place(const std::vector<double>& levels, double value) {
    return static_cast<int>(std::lower_bound(levels.begin(), levels.end(), value) - levels.begin());
}

struct Refit {
    Guess end;
    double improvement = 0.0;  ///< by the start at the fit of all rows
};

/// Refits of one hypothesis, each on some of the rows.
class Refits {
public:
    Refits(const Problem& problem, const Fit& null, const Fit& fit) : problem_(problem), null_(null), fit_(fit) {}

    /// From the nominal rig: build parameters first, then each cause upon them. Looks at the rows `kept` only.
    [[nodiscard]] Guess from_nominal(const std::vector<bool>& kept) const {
        Fit base = null_;
        base.x = descend(problem_, base.spread, null_.jacobian, {{}, problem_.start({}), 0.0}, {}, &kept).x;
        for (const effects::Cause& cause : fit_.causes) {
            Guess with = guess_upon(problem_, base, cause, &kept);
            base.causes = std::move(with.causes);
            base.x = std::move(with.x);
            base.jacobian = joined(null_.jacobian, columns_from(problem_, base.causes, base.x, null_.jacobian.cols()));
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
        return descend(problem_, fit_.spread, fit_.jacobian.leftCols(build), std::move(start), {}, &kept);
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
    Split split{Eigen::VectorXd::Zero(problem.residuals()), Eigen::VectorXd::Zero(problem.residuals()), std::vector<Eigen::VectorXd>(parts),
                std::vector<Eigen::VectorXd>(parts), std::vector<double>(parts)};
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
    const gap_case::Rows& rows = problem.gap_case().rows;
    std::vector<int> fold;
    const auto add = [&](int group, int columns) { fold.insert(fold.end(), static_cast<std::size_t>(columns), group % kFolds); };
    const std::vector<double> torques = levels(rows.breakaway, [](const auto& row) { return row.motor_torque; });
    for (const identification::BreakAway& row : rows.breakaway) add(place(torques, row.motor_torque), 1);
    for (std::size_t i = 0; i < rows.spring_pull.size(); ++i) add(static_cast<int>(i / kStretch), 1);
    const std::vector<double> widths = levels(rows.dead_band, [](const auto& row) { return row.cocontraction; });
    for (const gap_case::DeadBandRow& row : rows.dead_band) add(place(widths, row.cocontraction), rows.dead_band_width_only ? 1 : 2);
    for (std::size_t i = 0; i < rows.joint_stiffness.size(); ++i) add(static_cast<int>(i / kStretch), 1);
    for (std::size_t i = 0; i < rows.cocontraction.size(); ++i) add(static_cast<int>(i / kStretch), 3);
    const double stretch = kLogStretch * gap_case::reference_of(problem.gap_case().rig).time;
    for (const gap_case::LogRow& row : rows.log) add(static_cast<int>(std::abs(row.time - rows.log.front().time) / stretch), 3);
    return fold;
}

Split held_out(const Problem& problem, const Fit& null, const Fit& fit, unsigned jobs) {
    return by_groups(problem, null, fit, folds(problem), kFolds, jobs);
}

Split experiments_left_out(const Problem& problem, const Fit& null, const Fit& fit, unsigned jobs) {
    std::vector<int> group;
    for (int i = 0; i < problem.residuals(); ++i) group.push_back(static_cast<int>(problem.experiment_of(i)));
    return by_groups(problem, null, fit, group, static_cast<int>(gap_case::kExperiments), jobs);
}

}  // namespace fusee::inference
