#pragma once
#include "fusee/diagnosis/diagnose.h"
#include "fusee/diagnosis/gap_map.h"
#include "inference/fixture.h"

namespace fusee::fixtures {

/// Gap (17) of what `predict` makes of an answer, on the rows of the case: what its `gap.after` states.
inline double predicted_gap(const gap_case::Case& gap_case, const diagnosis::Diagnosis& answer) {
    const JointProblem problem(gap_case);
    const joint_model::Signals predicted = joint_model::measured(diagnosis::predict(gap_case, answer, gap_case.rows));
    const inference::Outputs outputs(predicted.of.begin(), predicted.of.end());
    const Eigen::VectorXd sigma = diagnosis::tolerance_sigma(problem, best_fit(problem, {}).jacobian);
    return diagnosis::root_mean_square(problem, problem.residual(outputs).cwiseQuotient(sigma));
}

}  // namespace fusee::fixtures
