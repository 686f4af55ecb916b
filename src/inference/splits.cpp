#include "fusee/inference/splits.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>

#include "fusee/core/parallel.h"
#include "fusee/gap_case/reference.h"

namespace fusee::inference {

namespace {

constexpr int kSteps = 2;            ///< of each refit
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
    Eigen::VectorXd x, sigma;
};

/// x refitted on the rows with kept[i], from `fit`.
Refit refitted(const Problem& problem, const Fit& fit, const std::vector<bool>& kept) {
    const Eigen::MatrixXd jacobian = fit.spread.cwiseInverse().asDiagonal() * fit.jacobian;
    Eigen::VectorXd x = fit.x, seen = fit.seen();
    double cost = cost_of(problem, fit.causes, seen, x, &kept);
    for (int i = 0; i < kSteps; ++i) {
        const Eigen::VectorXd next = linear_step(problem, fit.causes, x, seen, jacobian, &kept);
        const Eigen::VectorXd left = problem.residual(fit.causes, next).cwiseQuotient(fit.spread);
        const double now = cost_of(problem, fit.causes, left, next, &kept);
        if (now >= cost) break;
        x = next;
        seen = left;
        cost = now;
    }
    const Eigen::MatrixXd known = information(problem, fit, seen, &kept);
    return {x, known.llt().solve(Eigen::MatrixXd::Identity(x.size(), x.size())).diagonal().cwiseSqrt()};
}

Split by_groups(const Problem& problem, const Fit& fit, const std::vector<int>& group, int groups, unsigned jobs) {
    std::vector<Eigen::VectorXd> left(static_cast<std::size_t>(groups));
    Split split;
    split.x.resize(left.size());
    split.sigma.resize(left.size());
    core::parallel_for(left.size(), jobs, [&](std::size_t g) {
        std::vector<bool> kept(group.size());
        for (std::size_t i = 0; i < group.size(); ++i) kept[i] = group[i] != static_cast<int>(g);
        if (std::find(kept.begin(), kept.end(), false) == kept.end()) return;
        Refit refit = refitted(problem, fit, kept);
        left[g] = problem.residual(fit.causes, refit.x);
        split.x[g] = std::move(refit.x);
        split.sigma[g] = std::move(refit.sigma);
    });
    split.residual.resize(problem.residuals());
    for (int i = 0; i < problem.residuals(); ++i) split.residual[i] = left[static_cast<std::size_t>(group[static_cast<std::size_t>(i)])][i];
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

Split held_out(const Problem& problem, const Fit& fit, unsigned jobs) { return by_groups(problem, fit, folds(problem), kFolds, jobs); }

Split experiments_left_out(const Problem& problem, const Fit& fit, unsigned jobs) {
    std::vector<int> group;
    for (int i = 0; i < problem.residuals(); ++i) group.push_back(static_cast<int>(problem.experiment_of(i)));
    return by_groups(problem, fit, group, static_cast<int>(gap_case::kExperiments), jobs);
}

}  // namespace fusee::inference
