#include <Eigen/QR>
#include <cmath>

#include "penalised_fit.h"

namespace fusee::math {

namespace {

class DenseFit final : public PenalisedFit {
public:
    DenseFit(Eigen::MatrixXd design, Eigen::MatrixXd penalty, Eigen::VectorXd y)
        : PenalisedFit(static_cast<std::size_t>(design.rows()), design.squaredNorm() / penalty.squaredNorm()),
          design_(std::move(design)),
          penalty_(std::move(penalty)),
          y_(std::move(y)) {}

    [[nodiscard]] Result solve(double lambda) const override {
        const Eigen::Index rows = design_.rows(), count = design_.cols(), all = rows + penalty_.rows();
        Eigen::MatrixXd stacked(all, count);
        stacked << design_, std::sqrt(lambda) * penalty_;
        Eigen::VectorXd right = Eigen::VectorXd::Zero(all);
        right.head(rows) = y_;
        // Rank-revealing: without a penalty, knots without rows between them leave coefficients free; the least ones are chosen.
        const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors(stacked);
        const Eigen::VectorXd coefficients = factors.solve(right);
        Result result;
        result.coefficients.assign(coefficients.begin(), coefficients.end());
        result.residual = (design_ * coefficients - y_).squaredNorm();
        const Eigen::MatrixXd q = factors.householderQ() * Eigen::MatrixXd::Identity(all, factors.rank());
        result.parameters = q.topRows(rows).squaredNorm();
        return result;
    }

private:
    Eigen::MatrixXd design_, penalty_;
    Eigen::VectorXd y_;
};

}  // namespace

std::unique_ptr<const PenalisedFit> make_dense_fit(const std::vector<PenalisedFit::Row>& rows, std::size_t count) {
    const auto height = static_cast<Eigen::Index>(rows.size()), width = static_cast<Eigen::Index>(count);
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(height, width);
    Eigen::VectorXd y(height);
    for (Eigen::Index i = 0; i < height; ++i) {
        const PenalisedFit::Row& row = rows[static_cast<std::size_t>(i)];
        for (std::size_t j = 0; j < row.values.size(); ++j) design(i, static_cast<Eigen::Index>(row.first + j)) = row.values[j];
        y(i) = row.y;
    }
    Eigen::MatrixXd penalty = Eigen::MatrixXd::Zero(width - 3, width);
    for (Eigen::Index i = 0; i + 3 < width; ++i) penalty.row(i).segment<4>(i) << -1.0, 3.0, -3.0, 1.0;
    return std::make_unique<DenseFit>(std::move(design), std::move(penalty), std::move(y));
}

}  // namespace fusee::math
