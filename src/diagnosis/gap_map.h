#pragma once
#include <string>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/inference/problem.h"

namespace fusee::diagnosis {

/// Location of a measured value.
struct Place {
    gap_case::Experiment experiment = gap_case::Experiment::kBreakAway;
    double at = 0.0;        ///< of the experiment's variable
    std::string component;  ///< "agonist backdrive", "pe antagonist", "q_rad", ...
};
/// Of every residual. The variable is the one that `variable_of` names.
[[nodiscard]] std::vector<Place> places(const gap_case::Rows& rows);
[[nodiscard]] const char* variable_of(gap_case::Experiment experiment);  ///< "motor_torque_Nm", "deflection_rad", ...

/// Sigma of each residual with the build tolerances in it, in units of the problem's sigma: the unit of a gap
/// (docs/theory/diagnosis.md, eq. 17). From the slopes of the nominal rig.
[[nodiscard]] Eigen::VectorXd tolerance_sigma(const inference::Problem& problem, const Eigen::MatrixXd& build_slopes);

/// Root mean square of the weighted figures; kNoFigure if there are none. `only`: restricts it to one experiment.
[[nodiscard]] double root_mean_square(const inference::Problem& problem, const Eigen::VectorXd& figures,
                                      const gap_case::Experiment* only = nullptr);

/// Four cells per experiment with equal numbers of rows.
[[nodiscard]] std::vector<GapCell> gap_map(const inference::Problem& problem, const Eigen::VectorXd& before, const Eigen::VectorXd& after);
/// Contributions above the floor of 1, greatest first: share, range and component of each experiment.
[[nodiscard]] std::vector<GapContribution> gap_contributions(const inference::Problem& problem, const Eigen::VectorXd& gap);

}  // namespace fusee::diagnosis
