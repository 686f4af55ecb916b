#pragma once
#include <vector>

#include "fusee/inference/screen.h"

namespace fusee::inference {

/// Columns of the residual by the first parameters of x, then by the others.
[[nodiscard]] Eigen::MatrixXd joined(const Eigen::MatrixXd& first, const Eigen::MatrixXd& others);

/// The least cost first; those without one last.
void sort_by_cost(std::vector<Guess>& guesses);

struct DescendOptions {
    int steps = 12;          ///< at most
    double least = 0.01;     ///< it ends with a step that lowers the cost by no more
    double smallest = 0.05;  ///< share of a step that is tried
};
/// Gauss-Newton steps from `start.x` that lower the cost (eq. 10) on the rows `kept`, each tried in full, then at ever smaller shares.
/// Predictions have one dead-band repeat per level. The columns of the first parameters are constant, those of the others are taken at
/// every step.
/// @param spread of each row
/// @param held   d residual/dx of the first parameters
[[nodiscard]] Guess descend(const Problem& problem, const Eigen::VectorXd& spread, const Eigen::MatrixXd& held, Guess start,
                            const DescendOptions& options, const std::vector<bool>* kept = nullptr);

}  // namespace fusee::inference
