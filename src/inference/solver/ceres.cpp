#include <ceres/ceres.h>
#include <glog/logging.h>

#include "least_squares.h"

namespace fusee::inference {

namespace {

class Block : public ceres::CostFunction {
public:
    Block(const LeastSquares& problem, Eigen::Index size) : problem_(problem) {
        set_num_residuals(problem.residuals);
        mutable_parameter_block_sizes()->push_back(static_cast<int>(size));
    }
    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
        problem_.evaluate(parameters[0], residuals, jacobians == nullptr ? nullptr : jacobians[0]);
        return true;
    }

private:
    const LeastSquares& problem_;
};

/// Ceres tells about points where a rig runs away on stderr through glog, even if it is to be silent. Its summary has the same.
void silence_glog() {
    static const bool kSilent = (FLAGS_minloglevel = google::GLOG_FATAL) == google::GLOG_FATAL;
    static_cast<void>(kSilent);
}

void minimise(const LeastSquares& problem, Eigen::VectorXd& x) {
    ceres::Problem solver;
    solver.AddResidualBlock(new Block(problem, x.size()), nullptr, x.data());
    const int free = static_cast<int>(x.size() - static_cast<Eigen::Index>(problem.last.size()));
    for (int k = free; k < x.size(); ++k) {
        const core::Range& range = problem.last[static_cast<std::size_t>(k - free)];
        solver.SetParameterLowerBound(x.data(), k, range.low);
        solver.SetParameterUpperBound(x.data(), k, range.high);
    }
    ceres::Solver::Options how;
    how.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
    how.max_num_iterations = problem.steps;
    how.initial_trust_region_radius = 1e6;  // the problem is nearly linear: the first step is Gauss and Newton's
    how.function_tolerance = 2e-5;          // a step that is refused by a hair ends it too
    how.parameter_tolerance = 1e-4;
    how.max_num_line_search_step_size_iterations = 0;  // at bounds a step is cut; a search along it takes eight Jacobians
    how.logging_type = ceres::SILENT;
    silence_glog();
    ceres::Solver::Summary summary;
    ceres::Solve(how, &solver, &summary);
}

}  // namespace

}  // namespace fusee::inference

extern "C" void fusee_least_squares(const fusee::inference::LeastSquares& problem, Eigen::VectorXd& x) {
    fusee::inference::minimise(problem, x);
}
