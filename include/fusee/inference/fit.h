#pragma once
#include <Eigen/Core>
#include <vector>

#include "fusee/inference/constants.h"
#include "fusee/inference/problem.h"

namespace fusee::inference {

// Equations 8 to 12 of docs/theory/diagnosis.md.

/// Cauchy's loss in sigmas, c^2 ln(1 + r^2/c^2) (eq. 9): a slip in the model that the rig did not have puts a run of rows a
/// hundred sigmas off; the distance does not matter.
[[nodiscard]] double loss(double r);

/// How much less accurate each experiment's prediction is than on a faultless rig, >= 1: where all its rows deviate (a path full of
/// stick-slip, an effect outside the model) they are weighted with that accuracy, so that no experiment outvotes the others.
using Scales = std::vector<double>;

/// A hypothesis at its best parameters.
struct Fit {
    Causes causes;
    Eigen::VectorXd x;          ///< as Problem
    double cost = 0.0;          ///< weighted robust misfit and priors
    double log_evidence = 0.0;  ///< Laplace's approximation (eq. 12) [nats], up to a constant of the case
    Eigen::VectorXd residual;   ///< at x, unweighted
    Eigen::VectorXd spread;     ///< of each row, spread_of at x
    [[nodiscard]] Eigen::VectorXd seen() const { return residual.cwiseQuotient(spread); }
    Eigen::MatrixXd jacobian;    ///< of `residual` by x
    Eigen::MatrixXd covariance;  ///< of x
};

struct FitOptions {
    int steps = 20;  ///< Levenberg-Marquardt steps in a round, at most
    unsigned jobs = 1;
};
/// Least of sum w loss(residual) + sum (x/prior)^2 from `start`, bounds kept (Ceres).
[[nodiscard]] Fit fit(const Problem& problem, const Causes& causes, const Eigen::VectorXd& start, const FitOptions& options = {});

/// J^T W J + Lambda (eq. 12) with the weights of the loss at residuals `seen` (in spreads): information of the rows `kept` and of the
/// priors on x.
[[nodiscard]] Eigen::MatrixXd information(const Problem& problem, const Fit& fit, const Eigen::VectorXd& seen,
                                          const std::vector<bool>* kept = nullptr);

/// Uncertainty of the prediction of each row (eq. 8), in sigmas, >= 1: sqrt(1 + the square of what draws of x on opposite sides, within
/// its tolerance, do not share with a straight line). Where friction sticks and slips, the moment of a slip is ill-conditioned: such
/// rows carry little information, whatever their deviation.
[[nodiscard]] Eigen::VectorXd spread_of(const Problem& problem, const Causes& causes, const Eigen::VectorXd& x, unsigned jobs);
/// The build parameter with the largest deviation from its nominal value.
struct WorstNuisancePull {
    std::size_t parameter = 0;
    double sigmas = 0.0;  ///< with its sign
};
[[nodiscard]] WorstNuisancePull worst_nuisance_pull(const Problem& problem, const Fit& fit);
/// T of each experiment: the root of the mean loss of its rows (0 without rows).
[[nodiscard]] std::vector<double> misfits(const Problem& problem, const Eigen::VectorXd& residual);
/// What is left for an effect that no hypothesis has: by how much the log evidence would rise if every experiment had T = 1 [nats].
[[nodiscard]] double evidence_left(const Problem& problem, const Eigen::VectorXd& residual);
[[nodiscard]] Scales scales_of(const Problem& problem, const Eigen::VectorXd& residual, const std::vector<bool>* kept = nullptr);
/// Weights of rows in a fit: sqrt(weight) cut by the loss and the scales at `residual`; 0 where `kept` is false.
[[nodiscard]] Eigen::VectorXd robust_weights(const Problem& problem, const Eigen::VectorXd& residual,
                                             const std::vector<bool>* kept = nullptr);
/// The cost at a residual and x (eq. 10 and 11, without its last term): priors, and of each experiment its rows' weight times T^2, the mean
/// of loss(residual), up to T = kFair, from there on kFair^2 (1 + 2 ln(T/kFair)): the likelihood with an unknown accuracy. Rows that are
/// not `kept` do not count.
[[nodiscard]] double cost_of(const Problem& problem, const Causes& causes, const Eigen::VectorXd& residual, const Eigen::VectorXd& x,
                             const std::vector<bool>* kept = nullptr);
/// One Gauss-Newton step with a constant Jacobian: the best x for the rows `kept` in the linear model.
[[nodiscard]] Eigen::VectorXd linear_step(const Problem& problem, const Causes& causes, const Eigen::VectorXd& x,
                                          const Eigen::VectorXd& residual, const Eigen::MatrixXd& jacobian,
                                          const std::vector<bool>* kept = nullptr);

}  // namespace fusee::inference
