#pragma once
#include <string>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/problem.h"

namespace fusee::diagnosis {

/// Sigma of each residual with the build tolerances in it, in units of the problem's sigma: the unit of a gap
/// (docs/theory/diagnosis.md, eq. 17). From the slopes of the nominal rig.
[[nodiscard]] Eigen::VectorXd tolerance_sigma(const inference::Problem& problem, const Eigen::MatrixXd& build_slopes);

/// Root mean square of the weighted figures; kNoFigure if there are none. `only`: restricts it to one experiment.
[[nodiscard]] double root_mean_square(const inference::Problem& problem, const Eigen::VectorXd& figures, const std::size_t* only = nullptr);

/// Four cells per experiment with equal numbers of rows.
[[nodiscard]] std::vector<GapCell> gap_map(const inference::Problem& problem, const Eigen::VectorXd& before, const Eigen::VectorXd& after);
/// Contributions above the floor of 1, greatest first: share, range and component of each experiment.
[[nodiscard]] std::vector<GapContribution> gap_contributions(const inference::Problem& problem, const Eigen::VectorXd& gap);

}  // namespace fusee::diagnosis
