#include "descend.h"

#include <cmath>

namespace fusee::inference {

Eigen::MatrixXd joined(const Eigen::MatrixXd& first, const Eigen::MatrixXd& others) {
    Eigen::MatrixXd all(first.rows(), first.cols() + others.cols());
    all << first, others;
    return all;
}

Guess descend(const Problem& problem, const Eigen::VectorXd& spread, const Eigen::MatrixXd& held, Guess start,
              const DescendOptions& options, const std::vector<bool>* kept) {
    const auto seen = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
        return problem.thin_residual(start.causes, x).cwiseQuotient(spread);
    };
    const Eigen::MatrixXd first = spread.cwiseInverse().asDiagonal() * held;
    Eigen::VectorXd residual = seen(start.x);
    start.cost = cost_of(problem, start.causes, residual, start.x, kept);
    if (!std::isfinite(start.cost)) return start;  // a rig that runs away, as with a negative spring at the joint
    for (int i = 0; i < options.steps; ++i) {
        const Eigen::MatrixXd own = spread.cwiseInverse().asDiagonal() * problem.slopes(start.causes, start.x, held.cols(), start.x.size());
        const Eigen::VectorXd step = linear_step(problem, start.causes, start.x, residual, joined(first, own), kept) - start.x;
        if (!step.allFinite()) break;
        const double before = start.cost;
        for (double share = 1.0; share >= options.smallest && start.cost == before; share *= 0.4) {
            const Eigen::VectorXd x = start.x + share * step, left = seen(x);
            const double cost = cost_of(problem, start.causes, left, x, kept);
            if (!(cost < before)) continue;
            start.x = x;
            start.cost = cost;
            residual = left;
        }
        if (before - start.cost <= options.least) break;
    }
    return start;
}

}  // namespace fusee::inference
